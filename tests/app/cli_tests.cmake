# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# What works
scan_cli_test(WrapTorus "scanwrap $DATA/torus.xyz wrap info -o out.stl" FILES out.stl
  OUT "triangles +10000\n.*closed +yes\n.*genus +1\n")
scan_cli_test(WrapPly "scanwrap $DATA/multiview_scan.ply wrap -o out.ply" FILES out.ply)
scan_cli_test(Classic "scanwrap $DATA/plate_hole.xyz wrap --mode=classic info" OUT "triangles +9238\n")
scan_cli_test(SeveralOutputs "scanwrap $DATA/torus.xyz -o out1.ply wrap -o out2.obj -o out3.stl"
  FILES out1.ply out2.obj out3.stl)
scan_cli_test(FilesAreMerged "scanwrap $DATA/torus.xyz $DATA/helix.xyz info" OUT "^points +5425\n")
scan_cli_test(MeshAsPoints "scanwrap $DATA/torus.xyz wrap -o m.stl && scanwrap --as=points m.stl info"
  OUT "^points +5000\ntriangles +0\n")
scan_cli_test(Pipe "cat $DATA/torus.xyz | scanwrap - wrap -o - | scanwrap - info" OUT "triangles +10000\n")
scan_cli_test(RedirectedInput "scanwrap - info < $DATA/torus.xyz" OUT "^points +5000\n")
scan_cli_test(TableLeavesDataAlone "scanwrap $DATA/torus.xyz wrap info -o - 2> err > m.ply; head -c 4 m.ply; grep -q genus err"
  OUT "^ply\n")
scan_cli_test(TellsWhatIsLeftOut "scanwrap $DATA/plate_hole.xyz $DATA/plate_hole.xyz wrap --mode=classic -o out.stl 2>&1"
  FILES out.stl OUT "^scanwrap: wrap: 4954 of 9908 points repeat others and were merged; 333 of 4954 points are not on the surface\n$")
scan_cli_test(SaysNothingWhenAllIsWell "scanwrap $DATA/torus.xyz wrap -o out.stl 2>&1" FILES out.stl OUT "^$")
scan_cli_test(SpacingOfPoints "scanwrap $DATA/torus.xyz info" OUT "\nspacing +0\\.0[0-9]+\n")
scan_cli_test(AsciiOutputs "scanwrap $DATA/torus.xyz --encoding=ascii wrap -o out.stl -o out.ply && scanwrap $DATA/torus.xyz wrap -o b.ply && head -c 6 out.stl && grep -a -c 'format ascii' out.ply && scanwrap out.stl info && scanwrap out.ply -o c.ply && cmp b.ply c.ply"
  FILES out.ply out.stl OUT "^solid 1\n.*triangles +10000\n")
scan_cli_test(Picture "scanwrap $DATA/torus.xyz render --width=64 --height=48 -o out.png && file -b out.png || od -An -c -N4 out.png"
  FILES out.png OUT "PNG|P +N +G")
scan_cli_test(PictureByDefault "scanwrap $DATA/torus.xyz -o out.png" FILES out.png)
scan_cli_test(Record "scanwrap $DATA/torus.xyz wrap --quiet --json=- | python3 -c 'import json, sys; r = json.load(sys.stdin); print([s[\"verb\"] for s in r[\"steps\"]], r[\"status\"], r[\"steps\"][1][\"results\"][\"points-read\"])'"
  OUT "'open', 'wrap'. 0 5000")
scan_cli_test(RecordOfFailure "scanwrap $DATA/torus.xyz info --quiet -o out.stl --json=r.json; grep -c '\"state\": \"failed\"' r.json"
  OUT "^1\n")
scan_cli_test(JsonProgress "scanwrap $DATA/torus.xyz wrap --progress=json -o out.stl"
  FILES out.stl ERR "\"verb\":\"wrap\",\"phase\":\"[^\"]+\",\"fraction\":")
scan_cli_test(DryRun "scanwrap $DATA/torus.xyz wrap --dry-run -o out.stl"
  OUT "open .*wrap --fit=all --manifold=true --mode=auto --open=auto --region= --size=0\nsave out.stl")
scan_cli_test(Overwrite "touch out.stl; scanwrap $DATA/helix.xyz wrap --overwrite -o out.stl; test -s out.stl"
  FILES out.stl)
scan_cli_test(SameBytesOnAnyThreads "for n in 1 2 5; do scanwrap $DATA/torus.xyz --threads=$n wrap -o - | md5sum; done | sort -u | wc -l"
  OUT "^1\n")
scan_cli_test(PushThenPull "scanwrap $DATA/plate_hole.xyz wrap --mode=classic -o a.ply push --at=0,0,0 -o b.ply pull --at=0,0,0 -o c.ply && cmp a.ply c.ply && ! cmp -s a.ply b.ply")
scan_cli_test(PushByBlock "block=$(scanwrap $DATA/plate_hole.xyz wrap --mode=classic push --at=0,0,0 --preview --json=- --quiet | python3 -c 'import json, sys; print(json.load(sys.stdin)[\"steps\"][2][\"results\"][\"blocks\"])') && scanwrap $DATA/plate_hole.xyz wrap --mode=classic push --block=$block -o a.ply && scanwrap $DATA/plate_hole.xyz wrap --mode=classic push --at=0,0,0 -o b.ply && cmp a.ply b.ply")
scan_cli_test(PreviewChangesNothing "scanwrap $DATA/plate_hole.xyz wrap --mode=classic -o a.ply push --at=0,0,0 --deep --preview --verbose -o b.ply && cmp a.ply b.ply"
  ERR "triangles-new +[1-9]")
scan_cli_test(MarksMayBeRepeated "scanwrap $DATA/helix.xyz wrap --mode=classic push --at=-0.83,-0.47,0.5 --at=-0.83,0.47,1.5 --triangle=0,1 --verbose info"
  OUT "triangles" ERR "marks +4\n")
scan_cli_test(PushOfTheFinishedWrap "scanwrap $DATA/torus.xyz wrap push --at=0.65,0,0 info" OUT "closed +yes\n")
scan_cli_test(EditsGoOnBehindInfo "scanwrap $DATA/plate_hole.xyz wrap --mode=classic info push --at=0,0,0 --deep info" OUT "genus +0\n.*genus +1\n")
scan_cli_test(WrapAgain "scanwrap $DATA/plate_hole.xyz wrap -o a.ply wrap --mode=classic wrap -o b.ply && cmp a.ply b.ply")
scan_cli_test(FineTuneAndBack "scanwrap $DATA/torus.xyz wrap -o a.ply fine-tune --at=0.65,0,0 -o b.ply info" OUT "triangles +1000")
scan_cli_test(ShootThroughThePlate "scanwrap $DATA/plate_hole.xyz wrap --mode=classic shoot --at=0,0,2 --along=0,0,-1 info" OUT "genus +[1-9]")
scan_cli_test(RepairAngles "scanwrap $DATA/plate_hole.xyz wrap repair-angles --verbose info" ERR "repairs +[1-9]" OUT "closed +yes\n.*genus +1\n")
scan_cli_test(RemoveWebsOfASolid "scanwrap $DATA/torus.xyz wrap remove-webs -o out.stl" FILES out.stl ERR "^scanwrap: remove-webs: nothing changed\n$")
scan_cli_test(OpenOrCapped "scanwrap $DATA/monkey_saddle.xyz wrap --open=cap info wrap --open=keep info" OUT "closed +yes\n.*closed +no\n")
scan_cli_test(Front "scanwrap $DATA/torus.xyz wrap --mode=front info" OUT "triangles +10000\n.*genus +1\n")
scan_cli_test(Relax "scanwrap $DATA/torus.xyz wrap relax --max-deviation=0.01 --verbose info -o out.stl" FILES out.stl
  ERR "points-moved +5000\n.*largest-shift +0\\.00999" OUT "closed +yes\n.*genus +1\n")
scan_cli_test(RelaxedPartOfASurface "scanwrap $DATA/plate_hole.xyz wrap relax --keep-features=40 --region='plane(0,0,0, 1,0,0)' --verbose info" ERR "feature-edges +[1-9]" OUT "closed +yes\n")
scan_cli_test(Thicken "scanwrap $DATA/monkey_saddle.xyz wrap thicken --thickness=0.06 --verbose info -o out.stl" FILES out.stl
  ERR "strip-triangles +120\n.*triangles-folded +0\n" OUT "closed +yes\nmanifold +yes\noriented +yes\n.*genus +0\n")
scan_cli_test(ThickenTooMuch "scanwrap $DATA/monkey_saddle.xyz wrap thicken --thickness=1.5 --verbose crop --region=folded info"
  ERR "folded-at +[-0-9].*thicken: folds onto itself in [0-9]+ places?, [0-9]+ triangles: the region folded\n" OUT "\ntriangles +[1-9]")
scan_cli_test(ThickenARegion "scanwrap $DATA/torus.xyz wrap thicken --side=out --region='sphere(1,0,0,0.5)' info" OUT "components +2\n")
scan_cli_test(OffsetThereAndBack "scanwrap $DATA/torus.xyz wrap offset --distance=0.01 --verbose offset --distance=-0.01 info"
  ERR "points-moved +5000\n.*largest-deviation +0\\.01" OUT "triangles +10000\n.*closed +yes\n")
scan_cli_test(Sharpen "scanwrap $DATA/plate_hole.xyz wrap sharpen --verbose info" ERR "edges-cut +[0-9]+\n" OUT "closed +yes\nmanifold +yes\n")
scan_cli_test(Decimate "scanwrap $DATA/torus.xyz wrap decimate --ratio=10% --verbose info -o out.stl" FILES out.stl OUT "triangles +1000\n.*closed +yes\nmanifold +yes\n.*genus +1\n" ERR "triangles-before +10000\ntriangles-after +1000\n.*new-self-intersections +0\n.*largest-deviation-at-most +0\\.")
scan_cli_test(ThickSaddle "scanwrap $DATA/monkey_saddle.xyz wrap refine --mode=midpoint thicken --thickness=0.06 decimate --ratio=10% mend --preview --verbose info"
  ERR "triangles-folded +0\n.*triangles-after +3718\n.*new-self-intersections +0\n.*\nself-intersections +0\n" OUT "triangles +3718\n.*closed +yes\nmanifold +yes\noriented +yes\n.*genus +0\n")
scan_cli_test(DecimateToADeviation "scanwrap $DATA/torus.xyz wrap decimate --max-deviation=0.01 info" OUT "triangles +[0-9][0-9][0-9]+\n.*closed +yes\n.*genus +1\n")
scan_cli_test(DecimateByOpenMesh "scanwrap $DATA/torus.xyz wrap decimate --method=openmesh --triangles=2000 --longest-edge=0.3 info" OUT "triangles +2000\n.*closed +yes\n.*genus +1\n")
scan_cli_test(DecimateRatioWrong "scanwrap $DATA/torus.xyz wrap decimate --ratio=120%" EXIT 2 ERR "--ratio.*more than 0 and at most 100%")
scan_cli_test(RefineTwice "scanwrap $DATA/torus.xyz wrap refine --times=2 info" OUT "triangles +160000\n.*closed +yes\n.*genus +1\n")
scan_cli_test(RefineHereAndThere "scanwrap $DATA/torus.xyz wrap refine --mode=midpoint --region='sphere(1.35,0,0,0.3)' refine --region='sphere(1.35,0,0,0.2)' refine --region='sphere(1.35,0,0,0.4)' --verbose info" OUT "closed +yes\n.*genus +1\n" ERR "halves-joined +[1-9]")
scan_cli_test(FillHolesOfAnOpenTorus "scanwrap $DATA/torus.xyz wrap erase --region='box(0.9,-0.3,-1,2,0.3,1)' info fill-holes --shape=curved info" OUT "closed +no\n.*closed +yes\n.*genus +1\n")
scan_cli_test(FillHolesLeavesTheRim "scanwrap $DATA/monkey_saddle.xyz wrap fill-holes info" OUT "closed +no\n" ERR "left 1 [(]the rim of an open surface[)]")
scan_cli_test(RemeshEvenly "scanwrap $DATA/torus.xyz wrap remesh --edge-length=0.05 --verbose info" OUT "closed +yes\n.*genus +1\n" ERR "edges-of-that-length +0[.][89]")
scan_cli_test(BridgeNeedsTwoPlaces "scanwrap $DATA/torus.xyz wrap bridge --from=0,0,0 -o out.stl 2>&1; test ! -e out.stl" OUT "needs two places")
scan_cli_test(Help "scanwrap --help" OUT "operations:\n.*wrap .*--max-memory=")
scan_cli_test(VerbHelp "scanwrap wrap --help" OUT "--mode=auto.classic.front\n.*example:\n  scanwrap ")
scan_cli_test(Version "scanwrap --version" OUT "^scanwrap [0-9.]+\n$")
scan_cli_test(NamesBehindDashes "cp $DATA/torus.xyz ./--in.xyz; scanwrap -- --in.xyz info" OUT "^points +5000")
scan_cli_test(LinkIsKept "ln -s out.stl link.stl; scanwrap $DATA/torus.xyz wrap -o link.stl && test -L link.stl" FILES out.stl)
scan_cli_test(LongName "scanwrap $DATA/torus.xyz wrap -o \"$(printf 'a%.0s' {1..251}).stl\" && ls | wc -c" OUT "^256\n")
scan_cli_test(TooManyThreads "scanwrap $DATA/torus.xyz --threads=1000 wrap -o out.stl 2> err; cat err" FILES out.stl OUT "^$")
scan_cli_test(ClosedDescriptors "scanwrap $DATA/torus.xyz wrap --verbose --progress=json -o out.ply <&- >&- 2>&-; scanwrap out.ply info"
  FILES out.ply OUT "triangles +10000\n")
scan_cli_test(FullStderr "scanwrap $DATA/torus.xyz wrap --verbose --progress=json -o out.ply 2> /dev/full" FILES out.ply)
scan_cli_test(OtherLocale "LC_ALL=de_DE.UTF-8 scanwrap $DATA/torus.xyz wrap -o - | md5sum > a; scanwrap $DATA/torus.xyz wrap -o - | md5sum | cmp - a")
scan_cli_test(InputIsOutput "cp $DATA/torus.xyz in.xyz; scanwrap in.xyz -o out.ply && scanwrap out.ply wrap --overwrite -o out.ply && scanwrap out.ply info"
  FILES out.ply OUT "triangles +10000\n")
foreach(format ply stl obj png)
  scan_cli_test(SameBytes.${format} "scanwrap $DATA/torus.xyz --threads=1 wrap -o 1.${format} && scanwrap $DATA/torus.xyz --threads=2 wrap -o 2.${format} && scanwrap $DATA/torus.xyz --threads=2 wrap -o 3.${format} && '${CMAKE_COMMAND}' -E compare_files 1.${format} 2.${format} && '${CMAKE_COMMAND}' -E compare_files 2.${format} 3.${format}")
endforeach()
scan_cli_test(SamePictureOfPoints "for n in 1 2 2; do scanwrap $DATA/torus.xyz --threads=$n --overwrite -o 1.png && md5sum 1.png; done | sort -u | wc -l" OUT "^1\n")

scan_cli_test(MendTurns "scanwrap $DATA/torus.xyz wrap orient --flip=true orient --verbose info" ERR "triangles-turned +10000\n.*triangles-turned +10000\n" OUT "volume +[0-9]")
scan_cli_test(MendLeavesGoodSurfacesAlone "scanwrap $DATA/torus.xyz wrap -o a.ply mend -o b.ply && cmp a.ply b.ply" ERR "^scanwrap: mend: nothing changed\n$")
scan_cli_test(MendParts "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 0 0 1\\nv -1 0 0\\nv 0 -1 0\\nv 0 0 -1\\nf 1 3 2\\nf 1 2 4\\nf 1 4 3\\nf 2 3 4\\nf 1 5 6\\nf 1 7 5\\nf 1 6 7\\nf 5 7 6\\n' > t.obj; scanwrap t.obj mend --verbose info" OUT "components +2\n.*manifold +yes\n" ERR "non-manifold-points +1\n")
scan_cli_test(MendPreviewChangesNothing "printf 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3\\nf 1 3 4\\nf 1 2 3\\n' > t.obj; scanwrap t.obj mend --preview --verbose info" OUT "triangles +3\n" ERR "duplicates +1\n.*removed-duplicates +1\n")
scan_cli_test(MendMarksRegions "printf 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3\\nf 1 3 4\\nf 1 2 3\\n' > t.obj; scanwrap t.obj mend --mark erase --region=duplicates info" OUT "triangles +2\n")
scan_cli_test(MendKindsAreChecked "! scanwrap $DATA/torus.xyz wrap mend --fix=spike info" ERR "fix: 'spike' is no kind of defect")
# Projects, templates, batches
set(plate "scanwrap $DATA/plate_hole.xyz wrap --mode=classic push --at=0,0,0 --deep --quiet")
scan_cli_test(ProjectGoesOn "${plate} -o out.wrp && scanwrap out.wrp info" FILES out.wrp OUT "triangles +9908\n")
scan_cli_test(ProjectIsListed "${plate} -o out.wrp && scanwrap out.wrp" FILES out.wrp
  OUT "  1  open [^\n]*plate_hole.xyz +4,954 points .*  2  wrap --mode=classic +9,238 triangles .*[*] 3  push --at=0,0,0 --deep +9,908 triangles")
scan_cli_test(ProjectRemembersThePlace "${plate} -o out.wrp && scanwrap out.wrp history --go=2 && scanwrap out.wrp info && scanwrap out.wrp history --go=3 info"
  FILES out.wrp OUT "triangles +9238\n.*triangles +9908\n")
scan_cli_test(ProjectBranches "${plate} -o out.wrp && scanwrap out.wrp history --go=2 flatten history" FILES out.wrp OUT "3  [^ ]+ push.*[*] 4  [^ ]+ flatten")
scan_cli_test(StepsHaveNames "${plate} -o out.wrp && scanwrap out.wrp history --name=start --step=2 && scanwrap out.wrp history --go=start info" FILES out.wrp OUT "triangles +9238\n")
scan_cli_test(StepIsEdited "${plate} repair-angles -o out.wrp && scanwrap out.wrp history --edit=3 --set=deep=false history --step=5" FILES out.wrp
  OUT "step 3 again as step 5\nstep 4 again as step 6\n.*--deep +false\n")
scan_cli_test(StepsAreCompared "${plate} -o out.wrp && scanwrap out.wrp history --compare=2,3" FILES out.wrp
  OUT "only b  3  push --at=0,0,0 --deep\nsame +no\n.*triangles-b +9908\n.*mean-deviation-a-to-b +0")
scan_cli_test(BranchIsDeleted "${plate} -o out.wrp && scanwrap out.wrp history --delete=2 history" FILES out.wrp OUT "[*] 1  open [^\n]*\n$")
scan_cli_test(ProjectIsVerified "${plate} -o out.wrp && scanwrap out.wrp history --verify" FILES out.wrp OUT "all 3 steps come out the same")
scan_cli_test(ProjectIsChecked "${plate} -o out.wrp && scanwrap out.wrp history --check" FILES out.wrp OUT "every result is as it was stored")
scan_cli_test(CheckTellsDamage "${plate} -o a.wrp && python3 -c 'd = open(\"a.wrp\", \"rb\").read(); i = len(d) * 2 // 3; open(\"out.wrp\", \"wb\").write(d[:i] + b\"damaged\" + d[i + 7:])' && scanwrap out.wrp history --check"
  FILES out.wrp EXIT 3 OUT "the result of step [0-9] is damaged" ERR "a check failed")
scan_cli_test(VerifyTellsOtherPoints "cp $DATA/torus.xyz in.xyz && scanwrap in.xyz wrap -o out.wrp && echo 0 0 9 >> in.xyz && scanwrap out.wrp history --verify"
  FILES out.wrp EXIT 3 OUT "step 1: [^\n]*in.xyz: has changed" ERR "a check failed")
scan_cli_test(ProjectIsCopied "${plate} -o a.wrp && scanwrap a.wrp push --at=0.5,0.5,1 -o out.wrp && scanwrap a.wrp && scanwrap out.wrp" FILES out.wrp OUT "[*] 3  push.*[*] 4  push")
scan_cli_test(ProjectIsItsOwnOutput "${plate} -o a.wrp; scanwrap a.wrp push --at=0,0,0 --overwrite -o a.wrp" EXIT 2 ERR "keeps every step already")
scan_cli_test(ProjectAmongFiles "${plate} -o a.wrp; scanwrap a.wrp $DATA/torus.xyz info" EXIT 2 ERR "opened alone")
scan_cli_test(ProjectThatIsNone "head -c 5000 /dev/urandom > a.wrp; scanwrap a.wrp info" EXIT 2 ERR "no Scanwrap project")
scan_cli_test(TruncatedProject "${plate} -o a.wrp; truncate -s 200000 a.wrp; scanwrap a.wrp info" EXIT 2 ERR "damaged.*--salvage")
scan_cli_test(ProjectIsSalvaged "${plate} -o a.wrp && truncate -s -100000 a.wrp && scanwrap a.wrp history --salvage=out.wrp && scanwrap out.wrp" FILES out.wrp OUT "saved [1-3] steps.*open ")
scan_cli_test(FailedStepIsNotKept "${plate} -o out.wrp; scanwrap out.wrp push --triangle=99999 2> err; scanwrap out.wrp | wc -l" FILES out.wrp OUT "^3\n")
scan_cli_test(FailedRunKeepsItsSteps "scanwrap $DATA/plate_hole.xyz wrap push --triangle=99999 -o part.wrp 2> err; scanwrap part.wrp | wc -l" OUT "^2\n")
scan_cli_test(SecondProgramReads "${plate} -o a.wrp; python3 -c 'import fcntl, os, struct, time; fcntl.fcntl(os.open(\"a.wrp\", os.O_RDWR), 37, struct.pack(\"hhqqi\", 1, 0, 1 << 62, 1, 0)); open(\"ready\", \"w\"); time.sleep(60)' & until test -e ready; do sleep 0.1; done; scanwrap a.wrp info; scanwrap a.wrp flatten 2>&1; echo status $?; kill $!; wait $! 2> /dev/null; scanwrap a.wrp flatten 2>&1"
  OUT "triangles +9908\n.*scanwrap: flatten: a.wrp: nothing can be saved: another program has it open; work on a copy: -o COPY.wrp\nstatus 1\nscanwrap: flatten: nothing changed")
scan_cli_test(TemplateIsRun "${plate} -o a.wrp && scanwrap a.wrp history --save-template=t.txt && scanwrap $DATA/plate_hole.xyz --template=t.txt info" OUT "triangles +9908\n.*genus +1\n")
scan_cli_test(TemplateIsKept "${plate} -o a.wrp && scanwrap a.wrp history --keep-template=plate && scanwrap $DATA/plate_hole.xyz --template=a.wrp:plate info" OUT "genus +1\n")
scan_cli_test(TemplateThatIsNotKept "${plate} -o a.wrp && scanwrap $DATA/plate_hole.xyz --template=a.wrp:other info" EXIT 2 ERR "no such template")
scan_cli_test(TemplateThatIsNone "scanwrap $DATA/torus.xyz --template=$DATA/torus.xyz info" EXIT 2 ERR "line 1: is no template")
scan_cli_test(BatchTellsTheTruth "cp $DATA/torus.xyz a.xyz; cp $DATA/helix.xyz b.xyz; echo 1 2 x > c.xyz; scanwrap --batch='*.xyz' wrap -o 'out_{name}.stl' --jobs=2 --progress=none"
  EXIT 1 FILES out_a.stl out_b.stl ERR "see the table"
  OUT "a.xyz +ok +[0-9.]+  10000 triangles\nb.xyz +ok .*c.xyz +failed +[0-9.]+  c.xyz: line 1: .*\n3 files: 2 ok, 1 failed\n")
scan_cli_test(BatchResumes "cp $DATA/torus.xyz a.xyz; cp $DATA/helix.xyz b.xyz; scanwrap a.xyz wrap -o out_a.stl; scanwrap --batch='?.xyz' wrap -o 'out_{name}.stl' --resume --quiet && scanwrap --batch='{a,b}.xyz' wrap -o 'out_{name}.stl' --resume --quiet"
  FILES out_a.stl out_b.stl OUT "a.xyz +done before +0.00  \nb.xyz +ok .*2 files: 2 done before\n")
scan_cli_test(BatchOfAnalyses "cp $DATA/torus.xyz a.xyz; scanwrap --batch='*.xyz' wrap info --json=r.json && grep -c '\"result\": \"ok\"' r.json" OUT "a.xyz\npoints +5000\n.*1 files: 1 ok\n1\n")
scan_cli_test(BatchIntoOneFile "cp $DATA/torus.xyz a.xyz; cp a.xyz b.xyz; scanwrap --batch='*.xyz' wrap -o out.stl" EXIT 2 ERR "{name}")
scan_cli_test(BatchOfNothing "scanwrap --batch='*.xyz' wrap info" EXIT 2 ERR "no such file")
scan_cli_test(BatchIsCancelled "for i in 1 2 3 4 5 6; do cp $DATA/multiview_scan.ply $i.ply; done; '${CMAKE_BINARY_DIR}/bin/scanwrap' --batch='?.ply' wrap -o 'o{name}.stl' --progress=none & sleep 0.5; kill -INT $!; wait $!"
  EXIT 4 OUT "not started.*6 files: " ERR "--resume")
# Regions
scan_cli_test(CropAndEraseShareTheSurface "scanwrap $DATA/torus.xyz wrap select --name=half --rule='plane(0,0,0, 0,1,0)' crop --region=half info && scanwrap $DATA/torus.xyz wrap erase --region='plane(0,0,0, 0,1,0)' info"
  OUT "triangles +5005\n.*triangles +4995\n")
scan_cli_test(RegionsPassThroughAWrap "scanwrap $DATA/torus.xyz select --name=half --rule='plane(0,0,0, 0,1,0)' wrap crop --region=half info" OUT "triangles +5005\n")
scan_cli_test(RegionsOfRegions "scanwrap $DATA/torus.xyz select --name=a --rule='plane(0,0,0, 0,1,0)' select --name=b --rule='a & plane(0,0,0, 1,0,0)' select --name=a --rule=none select --name=c --rule=b --verbose -o out.ply 2>&1 | grep -E '^rule|nothing'"
  FILES out.ply OUT "rule +none\nrule +plane.0,0,0,0,1,0. & plane.0,0,0,1,0,0.\n.*nothing is in the region a\n$")
scan_cli_test(ALassoWithDepth "for depth in '' ' & depth(front, 0,0,0)'; do scanwrap $DATA/torus.xyz info --region=\"polygon(front, 0.8,-0.3, 1.2,0, 0.8,0.3)$depth\" | grep -E '^points|max-y'; done"
  OUT "^points +153\nbox-max-y +1.07[0-9]+\npoints +78\nbox-max-y +-0.0008[0-9]+\n$")
scan_cli_test(WrapARegion "scanwrap $DATA/torus.xyz select --name=half --rule='plane(0,0,0, 0,1,0)' wrap --region=half -o a.ply && scanwrap $DATA/torus.xyz crop --region='plane(0,0,0, 0,1,0)' wrap -o b.ply && cmp a.ply b.ply")
scan_cli_test(PushARegion "scanwrap $DATA/plate_hole.xyz wrap --mode=classic push --region='brush(3x, 0,0,9, 0,0,-9)' --deep info" OUT "genus +1\n")
foreach(edit IN ITEMS "repair-angles" "remove-webs --factor=0.5" "flatten")
  string(REGEX REPLACE " .*" "" name "${edit}")
  set(sample monkey_saddle.xyz)
  set(mode classic)
  if(name STREQUAL "repair-angles")
    set(sample plate_hole.xyz)
    set(mode auto)
  endif()
  scan_cli_test(ARegionOfNothingIsNowhere.${name} "scanwrap $DATA/${sample} wrap --mode=${mode} -o a.ply ${edit} --region=none -o b.ply ${edit} -o c.ply && cmp a.ply b.ply && ! cmp -s b.ply c.ply"
    ERR "scanwrap: ${name}: nothing changed\n")
endforeach()
scan_cli_test(PictureOfARegion "scanwrap $DATA/torus.xyz wrap render --region='plane(0,0,0, 0,1,0)' --width=64 --height=48 -o a.png crop --region='plane(0,0,0, 0,1,0)' render --width=64 --height=48 -o b.png && cmp a.png b.png")
scan_cli_test(SameRegionOnAnyThreads "for n in 1 2 5; do scanwrap $DATA/torus.xyz --threads=$n crop --region='grow(curvature(2, inf), 2) - component(9,9,9) + brush(4x, 1,0,0, 0,1,0)' -o - | md5sum; done | sort -u | wc -l" OUT "^1\n")
# Points
scan_cli_test(ThinRandomly "scanwrap $DATA/torus.xyz thin --by=random --keep=12.5 info" OUT "^points +625\n")
scan_cli_test(ThinBySpacing "scanwrap $DATA/torus.xyz thin --spacing=0.1 info | grep ^spacing" OUT "^spacing +0\\.1")
scan_cli_test(ThinByGrid "scanwrap $DATA/torus.xyz thin --by=grid --spacing=10 info" OUT "^points +1\n")
scan_cli_test(ThinByCurvature "scanwrap $DATA/plate_hole.xyz thin --by=curvature --keep=30 wrap info" OUT "points +14[0-9][0-9]\n.*closed +yes\n.*genus +1\n")
scan_cli_test(ThinIsTheSameOnAnyThreads "for n in 1 2 5; do scanwrap $DATA/torus.xyz --threads=$n thin --by=curvature -o - | md5sum; done | sort -u | wc -l" OUT "^1\n")
scan_cli_test(ThinNothing "scanwrap $DATA/torus.xyz thin --spacing=0 -o out.xyz" FILES out.xyz ERR "^scanwrap: thin: nothing changed\n$")
scan_cli_test(RemoveOutliers "(cat $DATA/torus.xyz; echo 9 9 9; echo 9.01 9 9) > in.xyz; scanwrap in.xyz remove-outliers --verbose info" OUT "^points +5000\n" ERR "points-removed +2\n")
scan_cli_test(RemoveOutliersOfACleanScan "scanwrap $DATA/torus.xyz remove-outliers info" OUT "^points +5000\n" ERR "no stray points found\n$")
scan_cli_test(Denoise "scanwrap $DATA/multiview_scan.ply denoise --max-shift=0.05 --verbose -o out.ply" FILES out.ply ERR "max-shift +0\\.05\n.*largest-shift +0\\.0[0-9]+\n")
scan_cli_test(Normals "scanwrap $DATA/torus.xyz normals -o out.ply && grep -a -c 'property.* nx' out.ply" FILES out.ply OUT "^1\n")
scan_cli_test(NormalsOfASheet "scanwrap $DATA/monkey_saddle.xyz normals -o out.ply" FILES out.ply ERR "1 of 1 connected parts have no inside; their normals point up\n$")
scan_cli_test(AddPoints "scanwrap $DATA/torus.xyz add --at='0,0,0;1,1,1' --at=2,2,2 --view=top --depth=0,0,5 info" OUT "^points +5003\n.*box-max-z +5\n")
scan_cli_test(MergeInTheMiddle "scanwrap $DATA/torus.xyz thin --by=random --keep=10 merge --file=$DATA/helix.xyz info" OUT "^points +925\n.*points-of model +500\npoints-of helix.xyz +425\n")
scan_cli_test(MergeNothing "scanwrap $DATA/torus.xyz merge info" EXIT 1 ERR "merge: there is no file to merge; name one with --file=PATH")
scan_cli_test(MergeMissing "scanwrap $DATA/torus.xyz merge --file=none.xyz info" EXIT 1 ERR "merge: none.xyz: cannot be read: No such file")
scan_cli_test(Align "awk '{ print $1, $2 * 0.6 + 0.02 * $1, $3 + 0.2 * $1 * $2 }' $DATA/torus.xyz > a.xyz; awk '{ print $1 + 0.02, $2 - 0.01, $3 + 0.01 }' a.xyz > b.xyz; scanwrap a.xyz b.xyz align --verbose -o out.xyz && sort out.xyz | head -1 | wc -l" FILES out.xyz
  ERR "scan +b.xyz\n.*shift +0\\.024494.*fit-rms +[0-9.]+e-0[789]\n" OUT "^1\n")
scan_cli_test(AlignByPairs "scanwrap $DATA/torus.xyz $DATA/torus.xyz align --scan=1 --from='0,0,0;1,0,0;0,1,0' --onto='0,0,1;1,0,1;0,1,1' --fit=false info" OUT "box-max-z +1\\.3")
scan_cli_test(AlignOnALine "scanwrap $DATA/torus.xyz $DATA/helix.xyz align --from='0,0,0;1,0,0;2,0,0' --onto='0,0,1;1,0,1;0,1,1' info" EXIT 2 ERR "align: the points of --from are on one line")
scan_cli_test(AlignOneFile "scanwrap $DATA/torus.xyz align info" EXIT 1 ERR "align: the model comes from a single file; open the scans to align together")
scan_cli_test(PointsTwice "scanwrap $DATA/torus.xyz normals --orient=toward --viewpoint='0,0,0;1,1,1' info" EXIT 2 ERR "normals: .*--viewpoint: one point is enough")

# Wrong usage: refused before any work
scan_cli_test(NoInput "scanwrap" EXIT 2 ERR "no input")
scan_cli_test(MistypedVerb "scanwrap $DATA/torus.xyz wrpa -o out.stl" EXIT 2 ERR "did you mean 'wrap'")
scan_cli_test(MistypedOption "scanwrap $DATA/torus.xyz wrap --mod=auto" EXIT 2 ERR "did you mean '--mode'")
scan_cli_test(MistypedGlobal "scanwrap --overwite $DATA/torus.xyz" EXIT 2 ERR "did you mean '--overwrite'")
scan_cli_test(WrongChoice "scanwrap $DATA/torus.xyz wrap --mode=foo -o out.stl" EXIT 2 ERR "auto.classic")
scan_cli_test(OutOfRange "scanwrap $DATA/torus.xyz render --width=9 -o out.png" EXIT 2 ERR "from 16 to 4096")
scan_cli_test(FileAfterVerb "scanwrap $DATA/torus.xyz wrap $DATA/helix.xyz -o out.stl" EXIT 2 ERR "files stand before")
scan_cli_test(ResultLost "scanwrap $DATA/torus.xyz wrap" EXIT 2 ERR "-o FILE")
scan_cli_test(OutputExists "touch out.stl; scanwrap $DATA/torus.xyz wrap -o out.stl" EXIT 2 ERR "exists already.*--overwrite"
  FILES out.stl)
scan_cli_test(OutputTwice "scanwrap $DATA/torus.xyz -o out.stl wrap -o out.stl" EXIT 2 ERR "twice")
scan_cli_test(UnknownExtension "scanwrap $DATA/torus.xyz wrap -o out.foo" EXIT 2 ERR "stl")
scan_cli_test(MissingFolder "scanwrap $DATA/torus.xyz wrap -o nowhere/out.stl" EXIT 2 ERR "nowhere/out.stl.*folder")
scan_cli_test(OutputIsFolder "mkdir d.stl; scanwrap $DATA/torus.xyz wrap -o d.stl" EXIT 2 ERR "is a directory")
scan_cli_test(OptionTwice "scanwrap $DATA/torus.xyz --threads=1 wrap --threads=2 -o out.stl" EXIT 2 ERR "--threads: is given twice")
scan_cli_test(VerbOptionTwice "scanwrap $DATA/torus.xyz wrap --fit=all --fit=robust -o out.stl" EXIT 2 ERR "--fit: is given twice")
scan_cli_test(EmptyRecordName "scanwrap $DATA/torus.xyz --json= wrap -o out.stl" EXIT 2 ERR "--json=: expected")
scan_cli_test(OutputTwiceByOtherNames "scanwrap $DATA/torus.xyz -o out.ply wrap -o ./out.ply" EXIT 2 ERR "./out.ply: is an output twice")
scan_cli_test(OutputTwiceByLink "ln -s . d; scanwrap $DATA/torus.xyz -o out.ply wrap -o d/out.ply" EXIT 2 ERR "twice")
scan_cli_test(RecordOverInput "cp $DATA/torus.xyz in.xyz; scanwrap in.xyz --overwrite wrap -o out.ply --json=./in.xyz" EXIT 2 ERR "in.xyz: is an input")
scan_cli_test(OutputNameTooLong "scanwrap $DATA/torus.xyz wrap -o \"$(printf 'a%.0s' {1..252}).stl\"" EXIT 2 ERR "name too long.*choose another")
scan_cli_test(OutputLinksInCircle "ln -s a.ply b.ply; ln -s b.ply a.ply; scanwrap $DATA/torus.xyz wrap -o a.ply" EXIT 2 ERR "symbolic links")
scan_cli_test(NameWithLineFeed "scanwrap \"$(printf 'no\\nfile.xyz')\" wrap -o out.stl" EXIT 2 ERR "no.file.xyz")
scan_cli_test(MalformedRule "scanwrap $DATA/torus.xyz -o out.ply wrap --region='box(1,2' -o out.stl" EXIT 2 ERR "^scanwrap: region: character 8: expected ',' of box")
scan_cli_test(DeepRule "scanwrap $DATA/torus.xyz info --region=$(printf '(%.0s' {1..9999})" EXIT 2 ERR "expected fewer functions within each other")

# Unreadable input
scan_cli_test(MissingFile "scanwrap none.xyz wrap -o out.stl" EXIT 2 ERR "none.xyz.*No such file")
scan_cli_test(Directory "mkdir d; scanwrap d wrap -o out.stl" EXIT 2 ERR "d: is a directory")
scan_cli_test(NameTooLong "scanwrap \"$(printf 'a%.0s' {1..300}).ply\" wrap -o out.stl" EXIT 2 ERR "cannot be read: File name too long")
scan_cli_test(LinksInCircle "ln -s a.ply b.ply; ln -s b.ply a.ply; scanwrap a.ply wrap -o out.stl" EXIT 2 ERR "a.ply: cannot be read: .*symbolic links")
scan_cli_test(OffNamedXyz "printf 'OFF\\n4 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n3 0 1 2\\n' > in.xyz; scanwrap in.xyz info" OUT "triangles +1")
scan_cli_test(OffThatLies "printf 'OFF\\n4 4 0\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n3 0 1 2\\n' > in.off; scanwrap in.off info" EXIT 2 ERR "in.off: .*face")
scan_cli_test(PtxNamedPts "printf '2\\n2\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n1 0 0 0\\n0 1 0 0\\n0 0 1 0\\n0 0 0 1\\n1 2 3 0.5\\n' > in.pts; scanwrap in.pts info" EXIT 2 ERR "in.pts: .*cell")
scan_cli_test(EveryFormatComesBack "scanwrap $DATA/torus.xyz wrap -o a.ply -o a.obj -o a.off -o a.3ds -o a.glb -o a.3mf && for f in a.*; do scanwrap $f info | grep -E '^(points|triangles|genus) '; done | sort | uniq -c"
  OUT "^ *6 genus +1\n +6 points +5000\n +6 triangles +10000\n$")
scan_cli_test(OptionsOfOutputs "scanwrap $DATA/torus.xyz wrap -o a.dxf -o b.dxf --faces=polyface -o a.wrl -o b.wrl --version=1.0 && grep -c 3DFACE a.dxf; grep -c POLYLINE b.dxf; head -c 10 a.wrl; head -c 10 b.wrl"
  OUT "^10000\n1\n#VRML V2.0#VRML V1.0")
scan_cli_test(OptionOfAnotherOutput "scanwrap $DATA/torus.xyz wrap -o a.stl --faces=polyface" EXIT 2 ERR "a.stl: STL has no option --faces")
scan_cli_test(OptionAheadOfOutput "scanwrap $DATA/torus.xyz wrap --consistent=false -o a.stl" EXIT 2 ERR "--consistent is an option of outputs; put it right behind an -o FILE")
scan_cli_test(BadOptionOfOutput "scanwrap $DATA/torus.xyz wrap -o a.dxf --faces=round" EXIT 2 ERR "--faces=round: .*3dface")
scan_cli_test(UnitsOfSomeFiles "scanwrap $DATA/torus.xyz -o a.glb 2> first; scanwrap a.glb $DATA/torus.xyz info" EXIT 2 ERR "only some of the files say what their unit is; give that of the others with --unit")
scan_cli_test(UnitOfFiles "scanwrap --unit=in $DATA/torus.xyz wrap -o a.3mf && scanwrap a.3mf info" OUT "\nunit +inch\n")
scan_cli_test(UnitIsInTheFile "scanwrap --unit=in $DATA/torus.xyz wrap -o a.3mf && scanwrap --unit=mm a.3mf info" OUT "\nunit +inch\n"
  ERR "a.3mf: says itself that its unit is inch")
scan_cli_test(UnitsAreConverted "scanwrap --unit=m $DATA/torus.xyz wrap -o a.3mf -o b.glb && scanwrap --unit=mm $DATA/torus.xyz wrap -o c.3mf && scanwrap c.3mf b.glb info"
  OUT "unit +millimetre\n.*box-max-x +1349\\." ERR "b.glb is converted from metre to millimetre")
scan_cli_test(UnknownUnit "scanwrap --unit=furlong $DATA/torus.xyz info" EXIT 2 ERR "--unit=furlong: .*mm")
scan_cli_test(Transforms "echo 'torus.xyz 1 0 0 10  0 1 0 0  0 0 1 0' > list; echo 'helix 0 0 0 0 0 0 1' >> list; scanwrap --transforms=list $DATA/torus.xyz $DATA/helix.xyz info"
  OUT "^points +5425\n.*box-max-x +11\\.3.*points-of torus.xyz +5000\npoints-of helix.xyz +425\n")
scan_cli_test(TransformIsMissing "echo 'other 0 0 0 0 0 0 1' > list; scanwrap --transforms=list $DATA/torus.xyz info" EXIT 2 ERR "list: there is no transform for '.*torus.xyz'; add a line")
scan_cli_test(TransformIsNone "echo 'torus.xyz 1 2 3' > list; scanwrap --transforms=list $DATA/torus.xyz info" EXIT 2 ERR "list: line 1")
scan_cli_test(ToleranceOfCadFiles "cp $DATA/../tests/fuzz/corpus/step/ball a.stp; for t in 1 1mm 0.01 5% 0.1%; do scanwrap --tolerance=$t a.stp info | grep ^triangles; done | sort -n -k 2 | uniq -c"
  OUT "^ +3 triangles +[0-9]+\n +1 triangles +[0-9]+\n +1 triangles +[0-9]+\n$")
scan_cli_test(ToleranceIsCheckedFirst "scanwrap --tolerance=-1 --dry-run $DATA/torus.xyz info" EXIT 2 ERR "--tolerance=-1: expected")
scan_cli_test(ToleranceOfNothing "cp $DATA/../tests/fuzz/corpus/step/ball a.stp; scanwrap --tolerance=0 a.stp info" EXIT 2 ERR "--tolerance=0: expected a length above 0 such as 0.1mm or 0.1%")
scan_cli_test(SurfacesAreMended "printf 'OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n-1 1 0\n-1 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n' > a.off; scanwrap a.off -o b.ply -o c.ply --consistent=false; scanwrap b.ply info; scanwrap c.ply info"
  OUT "points +9\n.*manifold +yes\n.*points +5\n.*manifold +no\n" ERR "b.ply: the surface is mended: 1 edge split, 2 points repeated")
foreach(entities faces 108 solid 186 nurbs 128 wireframe 106 points 116)
  if(entities MATCHES "^[0-9]")
    scan_cli_test(IgesEntities.${name} "scanwrap $DATA/torus.xyz wrap -o a.igs --entities=${name} && grep -c '^     ${entities} .*D' a.igs" OUT "^[1-9]")
  else()
    set(name ${entities})
  endif()
endforeach()
scan_cli_test(IgesOfManyTriangles "awk 'BEGIN { for (i = 0; i < 170; ++i) for (j = 0; j < 170; ++j) print i, j, sin(i / 9) * cos(j / 7) }' > a.xyz; scanwrap a.xyz wrap -o out.igs"
  FILES out.igs ERR "are as many surfaces to a CAD program, and most struggle above 50000")
scan_cli_test(LossesAreTold "printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n0 0 1 1 2 3\n3 0 1 2\n' > a.ply; scanwrap a.ply -o b.stl -o c.xyz -o d.ply --json=- | grep -c xx; scanwrap a.ply --overwrite -o b.stl -o c.xyz -o d.ply"
  OUT "^0\n" ERR "b.stl: 1 point that nothing uses left out; the format holds no colours; they are left out\n.*c.xyz: the format holds no triangles; they are left out\n")
scan_cli_test(BuffersBesideTheFile "mkdir 'a b'; python3 -c 'import base64, json, sys; j = json.load(open(sys.argv[1])); b = j[\"buffers\"][0]; open(\"a b/x y.bin\", \"wb\").write(base64.b64decode(b[\"uri\"].split(\",\")[1])); b[\"uri\"] = \"x%20y.bin\"; json.dump(j, open(\"a b/m.gltf\", \"w\"))' $DATA/../tests/fuzz/corpus/gltf/embedded.gltf; scanwrap 'a b/m.gltf' info | grep ^points; rm 'a b/x y.bin'; scanwrap 'a b/m.gltf' info"
  EXIT 2 OUT "^points +4\npoints-used +4\n$" ERR "a b/x y.bin cannot be opened: No such file")
scan_cli_test(BuffersElsewhere "printf '{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"/etc/passwd\",\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]}' > a.gltf; scanwrap a.gltf info"
  EXIT 2 ERR "a.gltf: a buffer is at '/etc/passwd', which is no file beside this one")
scan_cli_test(FormatTable "scanwrap --formats" OUT "^. format .*. IGES . igs, iges .")
scan_cli_test(GzipIsNotRead "gzip -c $DATA/helix.xyz > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz: is compressed with gzip; unpack it first")
scan_cli_test(DxfIsNotRead "scanwrap $DATA/helix.xyz -o out.dxf; scanwrap out.dxf info" FILES out.dxf EXIT 2 ERR "out.dxf: is a DXF drawing")
scan_cli_test(Utf16 "iconv -f ascii -t utf-16 $DATA/helix.xyz > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz: .*UTF-16")
scan_cli_test(ClosedStdin "scanwrap - wrap -o out.stl <&-" EXIT 2 ERR "standard input: cannot be read")
scan_cli_test(EmptyFile "touch in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz.*empty")
scan_cli_test(EmptyPipe "scanwrap - wrap -o out.stl < /dev/null" EXIT 2 ERR "standard input.*empty")
scan_cli_test(NotAScan "head -c 999 /dev/zero > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz")
scan_cli_test(UnknownContent "head -c 999 /dev/zero > in.foo; scanwrap in.foo wrap -o out.stl" EXIT 2 ERR "no known format")
scan_cli_test(NotANumber "printf '0 0 0\\nnan 0 1\\n1 1 1\\n' > in.xyz; scanwrap in.xyz info" OUT "^points +2\n"
  ERR "in.xyz: points whose coordinates are not a number left out: 1")
scan_cli_test(BrokenPlyIsNoText "printf 'plx\\n1 2 3\\n' > in.ply; scanwrap in.ply info" EXIT 2 ERR "in.ply: line 1: a PLY file starts with 'ply'")
scan_cli_test(SlicesNamedText "printf 'SLICE 1\\n0 0 0\\n1 0 0\\nSLICE 2\\n0 0 1\\n1 0 1\\n' > in.txt; scanwrap in.txt info" OUT "^points +4\n"
  ERR "not documented and was not verified")
scan_cli_test(EsriGridIsNotRead "printf 'ncols 2\\nnrows 2\\nxllcorner 0\\n1 2\\n3 4\\n' > in.asc; scanwrap in.asc info" EXIT 2 ERR "in.asc: is an ESRI grid of heights, which is not read; export it as XYZ")
scan_cli_test(Infinity "printf '0 0 0\\n1 inf 1\\n1 1 1\\n' > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz: .*line 2")
scan_cli_test(HugeCoordinates "printf '0 0 0\\n1e300 0 1\\n1 1 1\\n0 1 0\\n' > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 2 ERR "in.xyz")
scan_cli_test(TruncatedPly "head -c 3000 $DATA/multiview_scan.ply > in.ply; scanwrap in.ply wrap -o out.stl" EXIT 2 ERR "in.ply")
scan_cli_test(CountBeyondFile "printf 'ply\\nformat binary_little_endian 1.0\\nelement vertex 4000000000\\nproperty float x\\nproperty float y\\nproperty float z\\nend_header\\n' > in.ply; scanwrap in.ply wrap -o out.stl"
  EXIT 2 ERR "in.ply")

# Points that have no surface
scan_cli_test(OnePoint "echo 1 2 3 > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 1 ERR "wrap: ")
scan_cli_test(VerbIsNamedOnce "echo 1 2 3 > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 1 ERR "^scanwrap: wrap: [^:]*\n$")
scan_cli_test(EqualPoints "for i in 1 2 3 4 5 6; do echo 1 2 3; done > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 1 ERR "wrap: ")
scan_cli_test(CollinearPoints "for i in 1 2 3 4 5 6; do echo $i $i $i; done > in.xyz; scanwrap in.xyz wrap -o out.stl" EXIT 1 ERR "wrap: ")
scan_cli_test(CoplanarPoints "for i in 1 2 3; do for j in 1 2 3; do echo $i $j 0; done; done > in.xyz; scanwrap in.xyz wrap -o out.stl"
  EXIT 1 ERR "wrap: ")

# The machine's limits
scan_cli_test(FullDisk "scanwrap $DATA/torus.xyz wrap -o - > /dev/full" EXIT 1 ERR "standard output: disk full")
scan_cli_test(ClosedStdout "scanwrap $DATA/torus.xyz wrap -o - >&-" EXIT 1 ERR "standard output: is closed")
scan_cli_test(ReaderHasEnded "set -o pipefail; scanwrap $DATA/torus.xyz wrap -o - | true" EXIT 1 ERR "standard output: the program that reads it has ended")
scan_cli_test(FileTooLarge "ulimit -f 100; scanwrap $DATA/torus.xyz wrap -o out.stl" EXIT 1 ERR "out.stl.*larger than the system allows")
if(NOT SCAN_SANITIZE) # sanitizers reserve more than any limit
  scan_cli_test(OverMemory "awk 'BEGIN { srand(1); for (i = 0; i < 100000; ++i) print rand(), rand(), rand() }' > in.xyz; scanwrap --max-memory=40M in.xyz wrap -o out.stl" EXIT 5 ERR "out of memory")
  scan_cli_test(OverMemoryWhileReading "awk 'BEGIN { srand(1); for (i = 0; i < 100000; ++i) print rand(), rand(), rand() }' > in.xyz; scanwrap --max-memory=4M in.xyz wrap -o out.stl" EXIT 5 ERR "out of memory")
  scan_cli_test(OverMemoryOfThreads "awk 'BEGIN { srand(1); for (i = 0; i < 100000; ++i) print rand(), rand(), rand() }' > in.xyz; scanwrap --max-memory=22M --threads=2 in.xyz info" EXIT 5 ERR "memory")
  scan_cli_test(OverMemoryInPicture "scanwrap --max-memory=40M $DATA/torus.xyz -o out.png" EXIT 5 ERR "memory")
endif()
scan_cli_test(Interrupt "awk 'BEGIN { srand(1); for (i = 0; i < 300000; ++i) print rand(), rand(), rand() }' > in.xyz; '${CMAKE_BINARY_DIR}/bin/scanwrap' in.xyz wrap -o out.stl & sleep 1; kill -INT $!; wait $!"
  EXIT 4 ERR "cancelled")
scan_cli_test(InterruptPicture "awk 'BEGIN { srand(1); for (i = 0; i < 1000000; ++i) print rand(), rand(), rand() }' > in.xyz; '${CMAKE_BINARY_DIR}/bin/scanwrap' in.xyz --verbose -o out.png 2> err & sleep 1; kill -TERM $!; a=$(date +%s%3N); wait $!; s=$?; tail -1 err >&2; test $(($(date +%s%3N) - a)) -lt 900 && exit $s"
  EXIT 4 ERR "cancelled")
scan_cli_test(InterruptPipe "mkfifo f.ply; sleep 4 < f.ply > /dev/null 2>&1 & '${CMAKE_BINARY_DIR}/bin/scanwrap' $DATA/torus.xyz wrap -o f.ply & sleep 2; kill -INT $!; wait $!"
  EXIT 4 ERR "cancelled")

# Edits that cannot be
scan_cli_test(PushWithoutWrap "scanwrap $DATA/torus.xyz push --at=0,0,0 -o out.stl" EXIT 1 ERR "push: the model is no wrap that can be edited; put wrap before it")
scan_cli_test(PushOfAMesh "scanwrap $DATA/torus.xyz wrap -o m.stl; scanwrap m.stl push --at=0,0,0 -o out.stl" EXIT 1 ERR "put wrap before it")
scan_cli_test(MalformedPoint "scanwrap $DATA/torus.xyz wrap push --at=1,2 -o out.stl" EXIT 2 ERR "--at=1,2: expected x,y,z")
scan_cli_test(PointThatIsNoNumber "scanwrap $DATA/torus.xyz wrap push --at=nan,0,0 -o out.stl" EXIT 2 ERR "--at=nan,0,0: expected")
scan_cli_test(TriangleOutOfRange "scanwrap $DATA/torus.xyz wrap push --triangle=10000 -o out.stl" EXIT 2 ERR "there is no triangle 10000; the surface has 10000, counted from 0")
scan_cli_test(BlockThatIsNot "scanwrap $DATA/torus.xyz wrap push --block=99999999 -o out.stl" EXIT 2 ERR "there is no block 99999999")
scan_cli_test(ReachBelowOne "scanwrap $DATA/torus.xyz wrap push --at=0,0,0 --reach=0.5 -o out.stl" EXIT 2 ERR "--reach=0.5: expected a number from 1")
scan_cli_test(SelectWithoutAName "scanwrap $DATA/torus.xyz select --rule=all -o out.ply" EXIT 2 ERR "select: --name=: expected a name")
scan_cli_test(SelectWithoutARule "scanwrap $DATA/torus.xyz select --name=a -o out.ply" EXIT 2 ERR "select: --rule: expected what belongs")
scan_cli_test(CropWithoutARegion "scanwrap $DATA/torus.xyz crop -o out.ply" EXIT 2 ERR "crop: --region: expected the name of a region")
scan_cli_test(RegionThatIsNot "scanwrap $DATA/torus.xyz select --name=a --rule=all select --name=b --rule=none erase --region=c -o out.ply" EXIT 2 ERR "erase: region: character 1: expected a function or one of the regions a, b, found 'c'")
scan_cli_test(NegativeSize "scanwrap $DATA/torus.xyz wrap --size=-1 -o out.stl" EXIT 2 ERR "--size=-1: expected a length")
scan_cli_test(ShotAlongNothing "scanwrap $DATA/torus.xyz wrap shoot --at=0,0,2 --along=0,0,1e999 -o out.stl" EXIT 2 ERR "--along=0,0,1e999: expected")
