// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/data_form.h"

#include "filters/base/error.h"
#include "filters/geometry/wrap_delta.h"
#include "filters/wrap/vtkScanWrapData.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCharArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt16Array.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeInt8Array.h>
#include <vtkTypeUInt16Array.h>
#include <vtkTypeUInt32Array.h>
#include <vtkTypeUInt64Array.h>
#include <vtkTypeUInt8Array.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <string_view>
#include <utility>

namespace scan
{

namespace
{

static_assert(std::endian::native == std::endian::little);

constexpr const char* kText = "text";
constexpr const char* kPolyData = "polydata";
constexpr const char* kWrap = "wrap";

[[noreturn]] void refuse(const std::string& what)
{
  throw Error(ErrorCode::parse, "the stored result is damaged: " + what);
}

template <class Array>
vtkSmartPointer<vtkDataArray> make()
{
  return vtkSmartPointer<Array>::New();
}

struct ElementType
{
  std::string_view name;
  int vtkType; ///< that VTK calls it
  std::size_t width;
  vtkSmartPointer<vtkDataArray> (*make)();
};

/// The numeric types of VTK; the first one with a VTK type names it.
constexpr std::array<ElementType, 14> kTypes{ {
  { "float64", VTK_DOUBLE, 8, make<vtkDoubleArray> },
  { "float32", VTK_FLOAT, 4, make<vtkFloatArray> },
  { "id", VTK_ID_TYPE, sizeof(vtkIdType), make<vtkIdTypeArray> },
  { "uint8", VTK_UNSIGNED_CHAR, 1, make<vtkTypeUInt8Array> },
  { "int8", VTK_SIGNED_CHAR, 1, make<vtkTypeInt8Array> },
  { "int8", VTK_CHAR, 1, make<vtkTypeInt8Array> },
  { "uint16", VTK_UNSIGNED_SHORT, 2, make<vtkTypeUInt16Array> },
  { "int16", VTK_SHORT, 2, make<vtkTypeInt16Array> },
  { "uint32", VTK_UNSIGNED_INT, 4, make<vtkTypeUInt32Array> },
  { "int32", VTK_INT, 4, make<vtkTypeInt32Array> },
  { "uint64", VTK_UNSIGNED_LONG, 8, make<vtkTypeUInt64Array> },
  { "int64", VTK_LONG, 8, make<vtkTypeInt64Array> },
  { "uint64", VTK_UNSIGNED_LONG_LONG, 8, make<vtkTypeUInt64Array> },
  { "int64", VTK_LONG_LONG, 8, make<vtkTypeInt64Array> },
} };

const ElementType& typeNamed(const std::string& name)
{
  const auto* const found = std::ranges::find(kTypes, name, &ElementType::name);
  if (found == kTypes.end())
  {
    refuse("there is no type " + name);
  }
  return *found;
}

ArrayForm arrayForm(vtkDataArray& array)
{
  const auto* const type = std::ranges::find(kTypes, array.GetDataType(), &ElementType::vtkType);
  if (type == kTypes.end())
  {
    throw Error(ErrorCode::internal,
      std::string("arrays of ") + array.GetDataTypeAsString() + " cannot be stored");
  }
  const ArrayShape shape{ std::string(type->name), array.GetNumberOfComponents(),
    array.GetNumberOfTuples() };
  const auto size = static_cast<std::size_t>(array.GetNumberOfValues()) * type->width;
  const char* const first = size > 0 ? static_cast<const char*>(array.GetVoidPointer(0)) : nullptr;
  return { shape, { first, size }, std::make_shared<vtkSmartPointer<vtkDataArray>>(&array) };
}

ArrayForm arrayForm(vtkStringArray& array)
{
  auto text = std::make_shared<std::string>();
  for (vtkIdType i = 0; i < array.GetNumberOfValues(); ++i)
  {
    *text += array.GetValue(i);
    text->push_back('\0');
  }
  return { { kText, 1, static_cast<std::int64_t>(text->size()) }, *text, text };
}

/// Of something that `owner` keeps and nobody changes.
template <class Values>
ArrayForm arrayForm(
  const char* type, int components, const Values& values, std::shared_ptr<const void> owner)
{
  const std::span<const char> bytes{ reinterpret_cast<const char*>(std::data(values)),
    std::size(values) * sizeof(*std::data(values)) };
  const std::size_t width = typeNamed(type).width * static_cast<std::size_t>(components);
  return { { type, components, static_cast<std::int64_t>(bytes.size() / width) }, bytes,
    std::move(owner) };
}

class FormOfModel
{
public:
  explicit FormOfModel(vtkPolyData& model)
    : Model(model)
  {
  }

  DataForm form()
  {
    this->Form.kind = kPolyData;
    if (this->Model.GetPoints() != nullptr)
    {
      this->add("points", *this->Model.GetPoints()->GetData());
    }
    this->addCells("verts", *this->Model.GetVerts());
    this->addCells("lines", *this->Model.GetLines());
    this->addCells("polys", *this->Model.GetPolys());
    this->addCells("strips", *this->Model.GetStrips());
    this->addData(this->Model);
    return std::move(this->Form);
  }

  DataForm formOfWrap(vtkScanWrapData& wrap)
  {
    const WrapModel& model = wrap.GetModel();
    const DelaunayComplex& complex = model.scan->delaunay();
    this->Form.kind = kWrap;
    this->Form.facts = {
      { "duplicates", std::to_string(complex.duplicates) },
      { "solid", std::to_string(int{ model.isSolid }) },
      { "split", std::to_string(int{ wrap.IsSplit() }) },
      { "blocks", std::to_string(int{ wrap.HasBlocks() }) },
      { "open", std::to_string(int{ wrap.GetReport().isOpen }) },
      { "opening-triangles", std::to_string(wrap.GetReport().openingTriangles) },
      { "start-follows-flow", std::to_string(int{ model.start->followsFlow() }) },
      { "current-follows-flow", std::to_string(int{ model.current->followsFlow() }) },
    };
    auto& arrays = this->Form.arrays;
    arrays["complex.points"] = arrayForm("float64", 3, complex.points, model.scan);
    arrays["complex.scan-points"] = arrayForm("uint32", 1, complex.scanPoint, model.scan);
    arrays["complex.tetrahedra"] = arrayForm("uint32", 4, complex.tetrahedra, model.scan);
    arrays["complex.mirror"] = arrayForm("uint32", 4, complex.mirror, model.scan);
    arrays["wrap.start"] = arrayForm("uint8", 1, model.start->bytes(), model.start);
    if (!(*model.current == *model.start))
    {
      auto delta = std::make_shared<const std::vector<std::uint8_t>>(
        deltaOf(*model.start, *model.current, model.scan->basins()));
      arrays["wrap.delta"] = arrayForm("uint8", 1, *delta, delta);
    }
    static_assert(sizeof(CriticalEdge) == 4 * sizeof(Index));
    arrays["wrap.lines"] = arrayForm("uint32", 4, *model.lines, model.lines);
    if (model.inside)
    {
      arrays["wrap.inside"] = arrayForm("uint8", 1, *model.inside, model.inside);
    }
    arrays["wrap.input-ids"] = arrayForm("id", 1, *wrap.GetInputIds(), wrap.GetInputIds());
    this->addData(wrap);
    return std::move(this->Form);
  }

private:
  void add(const std::string& role, vtkDataArray& array)
  {
    this->Form.arrays[role] = arrayForm(array);
  }

  void addData(vtkPolyData& model)
  {
    this->addAttributes("point-data", *model.GetPointData());
    this->addAttributes("cell-data", *model.GetCellData());
    this->addArrays("field-data", *model.GetFieldData());
  }

  void addCells(const std::string& role, vtkCellArray& cells)
  {
    this->add(role + ".offsets", *cells.GetOffsetsArray());
    this->add(role + ".connectivity", *cells.GetConnectivityArray());
  }

  /// Arrays that the surface of a wrap brings with it are left out.
  void addArrays(const std::string& role, vtkFieldData& data)
  {
    const bool isWrap = this->Form.kind == kWrap;
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data.GetAbstractArray(i);
      const std::string name = array->GetName() != nullptr ? array->GetName() : "";
      if (isWrap && vtkScanWrapData::IsOwnArray(name))
      {
        continue;
      }
      // the number keeps their order
      std::string place = role;
      place.append(":").append(std::to_string(i)).append(":").append(name);
      if (auto* const numbers = vtkDataArray::SafeDownCast(array))
      {
        this->add(place, *numbers);
      }
      else if (auto* const texts = vtkStringArray::SafeDownCast(array))
      {
        this->Form.arrays[place] = arrayForm(*texts);
      }
    }
  }

  void addAttributes(const std::string& role, vtkDataSetAttributes& data)
  {
    this->addArrays(role, data);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      if (vtkAbstractArray* const active = data.GetAbstractAttribute(type);
          active != nullptr && active->GetName() != nullptr)
      {
        this->Form.facts[role + "." + vtkDataSetAttributes::GetAttributeTypeAsString(type)] =
          active->GetName();
      }
    }
  }

  vtkPolyData& Model;
  DataForm Form;
};

class ModelOfForm
{
public:
  ModelOfForm(const StoredForm& form, const ReadArray& read)
    : Form(form)
    , Read(read)
  {
  }

  vtkSmartPointer<vtkPolyData> model()
  {
    auto model = vtkSmartPointer<vtkPolyData>::New();
    if (this->has("points"))
    {
      vtkNew<vtkPoints> points;
      const auto coordinates = this->numbers("points");
      if (coordinates->GetNumberOfComponents() != 3)
      {
        refuse("points need three coordinates");
      }
      points->SetData(coordinates);
      model->SetPoints(points);
    }
    const vtkIdType count = model->GetNumberOfPoints();
    model->SetVerts(this->cells("verts", count));
    model->SetLines(this->cells("lines", count));
    model->SetPolys(this->cells("polys", count));
    model->SetStrips(this->cells("strips", count));
    this->addAll(*model);
    return model;
  }

  vtkSmartPointer<vtkPolyData> wrap(LoadedComplexes& complexes, Execution& execution)
  {
    execution.plan({ { "read", 4.0 }, { "classify", 2.0 }, { "basins", 2.0 }, { "surface", 3.0 },
      { "blocks", 1.0 } });
    WrapModel model;
    model.scan = this->complex(complexes, execution);
    const FlowComplex& flow = model.scan->flow();
    model.start = std::make_shared<const WrapComplex>(flow,
      this->values<std::vector<std::uint8_t>>("wrap.start"), this->isTrue("start-follows-flow"));
    model.current = this->currentState(model);
    model.lines = std::make_shared<const std::vector<CriticalEdge>>(this->lines(flow.delaunay()));
    if (this->has("wrap.inside"))
    {
      model.inside = std::make_shared<const std::vector<std::uint8_t>>(
        this->values<std::vector<std::uint8_t>>("wrap.inside"));
      if (model.inside->size() != flow.delaunay().tetCount())
      {
        refuse("sides of tetrahedra are missing");
      }
    }
    model.isSolid = this->isTrue("solid");
    WrapReport kept;
    kept.isOpen = this->isTrue("open");
    kept.openingTriangles = this->number("opening-triangles");

    auto data = vtkSmartPointer<vtkScanWrapData>::New();
    data->SetModel(model, this->inputIds(flow.delaunay()), this->isTrue("split"),
      this->isTrue("blocks"), kept, execution);
    this->addAll(*data);
    return data;
  }

private:
  bool has(const std::string& role) const { return this->Form.arrays.contains(role); }

  const StoredForm::Array& at(const std::string& role) const
  {
    const auto found = this->Form.arrays.find(role);
    if (found == this->Form.arrays.end())
    {
      refuse(role + " is missing");
    }
    return found->second;
  }

  Index number(const std::string& fact) const
  {
    const auto found = this->Form.facts.find(fact);
    const std::string text = found != this->Form.facts.end() ? found->second : "";
    Index value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size())
    {
      refuse(fact + " is no number");
    }
    return value;
  }

  bool isTrue(const std::string& fact) const { return this->number(fact) != 0; }

  vtkSmartPointer<vtkDataArray> numbers(const std::string& role) const
  {
    const StoredForm::Array& stored = this->at(role);
    const std::size_t size = sizeOf(stored.shape);
    auto array = typeNamed(stored.shape.type).make();
    array->SetNumberOfComponents(stored.shape.components);
    array->SetNumberOfTuples(stored.shape.tuples);
    this->Read(stored, { size > 0 ? static_cast<char*>(array->GetVoidPointer(0)) : nullptr, size });
    return array;
  }

  vtkSmartPointer<vtkStringArray> texts(const std::string& role) const
  {
    const StoredForm::Array& stored = this->at(role);
    std::string bytes(sizeOf(stored.shape), '\0');
    this->Read(stored, bytes);
    auto array = vtkSmartPointer<vtkStringArray>::New();
    for (std::size_t end = 0, begin = 0; (end = bytes.find('\0', begin)) != std::string::npos;
         begin = end + 1)
    {
      array->InsertNextValue(bytes.substr(begin, end - begin));
    }
    return array;
  }

  template <class Values>
  Values values(const std::string& role) const
  {
    const StoredForm::Array& stored = this->at(role);
    constexpr std::size_t kSize = sizeof(typename Values::value_type);
    const std::size_t size = sizeOf(stored.shape);
    if (size != static_cast<std::size_t>(stored.shape.tuples) * kSize)
    {
      refuse(role + " has another shape");
    }
    Values result(static_cast<std::size_t>(stored.shape.tuples));
    this->Read(stored, { reinterpret_cast<char*>(result.data()), size });
    return result;
  }

  vtkSmartPointer<vtkCellArray> cells(const std::string& role, vtkIdType pointCount) const
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (!this->has(role + ".offsets"))
    {
      return cells;
    }
    const auto offsets = this->numbers(role + ".offsets");
    const auto connectivity = this->numbers(role + ".connectivity");
    const auto set = [&]<class Array>(Array*)
    {
      auto* const ends = Array::SafeDownCast(offsets);
      auto* const ids = Array::SafeDownCast(connectivity);
      if (ends == nullptr || ids == nullptr)
      {
        return false;
      }
      using Id = typename Array::ValueType;
      const std::span<const Id> e(
        ends->GetPointer(0), static_cast<std::size_t>(ends->GetNumberOfValues()));
      const std::span<const Id> i(
        ids->GetPointer(0), static_cast<std::size_t>(ids->GetNumberOfValues()));
      if (e.empty() || e.front() != 0 || static_cast<std::size_t>(e.back()) != i.size() ||
        !std::ranges::is_sorted(e) ||
        std::ranges::any_of(i, [&](Id id) { return id < 0 || id >= pointCount; }))
      {
        refuse("the " + role + " do not fit the points");
      }
      cells->SetData(ends, ids);
      return true;
    };
    if (!set(static_cast<vtkTypeInt32Array*>(nullptr)) &&
      !set(static_cast<vtkTypeInt64Array*>(nullptr)))
    {
      refuse("the " + role + " are no numbers of points");
    }
    return cells;
  }

  std::shared_ptr<const ScanComplex> complex(LoadedComplexes& complexes, Execution& execution) const
  {
    std::weak_ptr<const ScanComplex>& loaded = complexes[complexOf(this->Form)];
    if (auto known = loaded.lock())
    {
      return known;
    }
    DelaunayComplex complex;
    complex.points = this->values<std::vector<Vec3>>("complex.points");
    execution.step("read", 1, 4);
    complex.scanPoint = this->values<std::vector<Index>>("complex.scan-points");
    complex.tetrahedra = this->values<LargeArray<std::array<Index, 4>>>("complex.tetrahedra");
    execution.step("read", 2, 4);
    complex.mirror = this->values<LargeArray<std::array<Facet, 4>>>("complex.mirror");
    execution.step("read", 4, 4);
    complex.duplicates = this->number("duplicates");
    auto made = std::make_shared<const ScanComplex>(std::move(complex), execution);
    loaded = made;
    return made;
  }

  std::shared_ptr<const WrapComplex> currentState(const WrapModel& model) const
  {
    const bool followsFlow = this->isTrue("current-follows-flow");
    if (!this->has("wrap.delta"))
    {
      if (followsFlow == model.start->followsFlow())
      {
        return model.start;
      }
      auto same = std::make_shared<WrapComplex>(*model.start);
      same->setFollowsFlow(followsFlow);
      return same;
    }
    return std::make_shared<const WrapComplex>(applyDelta(*model.start,
      this->values<std::vector<std::uint8_t>>("wrap.delta"), model.scan->basins(), followsFlow));
  }

  std::vector<CriticalEdge> lines(const DelaunayComplex& complex) const
  {
    auto lines = this->values<std::vector<CriticalEdge>>("wrap.lines");
    const auto points = static_cast<Index>(complex.points.size());
    if (std::ranges::any_of(lines,
          [&](const CriticalEdge& line)
          {
            return line.vertices[0] >= points || line.vertices[1] >= points ||
              line.triangle >= 4 * complex.tetCount() || line.apex >= points;
          }))
    {
      refuse("lines do not fit the points");
    }
    return lines;
  }

  vtkScanWrapData::PointIds inputIds(const DelaunayComplex& complex) const
  {
    auto ids = this->values<std::vector<vtkIdType>>("wrap.input-ids");
    if (std::ranges::any_of(complex.scanPoint, [&](Index point) { return point >= ids.size(); }))
    {
      refuse("numbers of scan points are missing");
    }
    return std::make_shared<const std::vector<vtkIdType>>(std::move(ids));
  }

  void addAll(vtkPolyData& model) const
  {
    this->addArrays("point-data", *model.GetPointData(), model.GetNumberOfPoints());
    this->addArrays("cell-data", *model.GetCellData(), model.GetNumberOfCells());
    this->addArrays("field-data", *model.GetFieldData(), -1);
    this->setAttributes("point-data", *model.GetPointData());
    this->setAttributes("cell-data", *model.GetCellData());
  }

  void addArrays(const std::string& role, vtkFieldData& data, vtkIdType tuples) const
  {
    std::map<int, std::pair<std::string, std::string>> inOrder; // number -> name and place
    const std::string start = role + ":";
    for (const auto& [place, stored] : this->Form.arrays)
    {
      if (place.starts_with(start))
      {
        const std::size_t colon = place.find(':', start.size());
        int number = 0;
        std::from_chars(place.data() + start.size(), place.data() + place.size(), number);
        inOrder[number] = { place.substr(std::min(colon, place.size() - 1) + 1), place };
      }
    }
    for (const auto& [number, names] : inOrder)
    {
      const vtkSmartPointer<vtkAbstractArray> array = this->at(names.second).shape.type == kText
        ? vtkSmartPointer<vtkAbstractArray>(this->texts(names.second))
        : vtkSmartPointer<vtkAbstractArray>(this->numbers(names.second));
      if (tuples >= 0 && array->GetNumberOfTuples() != tuples)
      {
        refuse(names.second + " has another length");
      }
      array->SetName(names.first.c_str());
      data.AddArray(array);
    }
  }

  void setAttributes(const std::string& role, vtkDataSetAttributes& data) const
  {
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      const auto name =
        this->Form.facts.find(role + "." + vtkDataSetAttributes::GetAttributeTypeAsString(type));
      if (name != this->Form.facts.end())
      {
        data.SetActiveAttribute(name->second.c_str(), type);
      }
    }
  }

  const StoredForm& Form;
  const ReadArray& Read;
};

} // namespace

std::size_t widthOf(const std::string& type)
{
  return type == kText ? 1 : typeNamed(type).width;
}

std::size_t sizeOf(const ArrayShape& shape)
{
  constexpr std::int64_t kMost = std::int64_t{ 1 } << 48U;
  constexpr int kMostComponents = 1024;
  if (shape.tuples < 0 || shape.tuples > kMost || shape.components < 1 ||
    shape.components > kMostComponents)
  {
    refuse("an array has an impossible size");
  }
  return static_cast<std::size_t>(shape.tuples) * static_cast<std::size_t>(shape.components) *
    widthOf(shape.type);
}

DataForm formOf(vtkPolyData& model)
{
  auto* const wrap = vtkScanWrapData::SafeDownCast(&model);
  FormOfModel former(model);
  return wrap != nullptr && wrap->GetModel().scan ? former.formOfWrap(*wrap) : former.form();
}

Hash complexOf(const StoredForm& form)
{
  const auto duplicates = form.facts.find("duplicates");
  std::string hashes = duplicates != form.facts.end() ? duplicates->second : "";
  for (const auto& [role, array] : form.arrays)
  {
    if (role.starts_with("complex."))
    {
      hashes.append(array.hash.bytes.data(), array.hash.bytes.size());
    }
  }
  return hashOf(hashes);
}

vtkSmartPointer<vtkPolyData> modelOf(
  const StoredForm& form, const ReadArray& read, LoadedComplexes& complexes, Execution& execution)
{
  ModelOfForm maker(form, read);
  if (form.kind == kWrap)
  {
    return maker.wrap(complexes, execution);
  }
  if (form.kind != kPolyData)
  {
    refuse("there is no kind " + form.kind);
  }
  return maker.model();
}

} // namespace scan
