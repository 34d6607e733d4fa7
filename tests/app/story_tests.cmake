# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Whole sessions of wrapping by hand, with the exact counts of the definition.
scan_cli_test(StoryOfThePlate "scanwrap $SHARED/synthetic/plate_hole.xyz wrap --mode=classic push --at=0,0,0 --deep --verbose info"
  ERR "boundary-triangles +9238\nsheet-triangles +0\n.*blocks-removed +130\ndoors-removed +131\n.*points-before +4621\npoints-on-surface +4954\n.*boundary-triangles +9908\nsheet-triangles +0\n"
  OUT "^points +4954\ntriangles +9908\n.*closed +yes\nmanifold +yes\n.*euler-characteristic +0\ngenus +1\n")
scan_cli_test(StoryOfTheTorus "scanwrap $SHARED/synthetic/torus5k.xyz wrap --mode=classic push --at=0,0,0 --verbose info"
  ERR "boundary-triangles +10002\nsheet-triangles +3\n.*blocks-removed +1\ndoors-removed +0\nblocks +-[0-9]+\n.*boundary-triangles +10000\nsheet-triangles +0\n"
  OUT "^points +5000\ntriangles +10000\n.*closed +yes\nmanifold +yes\n.*genus +1\n")
scan_cli_test(StoryOfTheHelix "scanwrap $SHARED/synthetic/helix.xyz wrap --mode=classic push --at=-0.83,-0.47,0.5 --deep push --at=-0.83,0.47,1.5 --deep push --at=-0.781514,-0.522191,0.6875 --at=-0.921859,-0.183369,0.5625 --at=-0.921859,0.183369,0.4375 --at=-0.183369,-0.921859,0.9375 --at=-0.522191,-0.781514,0.8125 --at=-0.921859,0.183369,1.4375 --at=0.183369,-0.921859,1.0625 --at=-0.921859,-0.183369,1.5625 --at=-0.781514,0.522191,1.3125 --at=-0.183369,0.921859,1.0625 --at=-0.522191,0.781514,1.1875 --at=0.183369,0.921859,0.9375 --at=0.921859,0.183369,0.5625 --at=0.781514,0.522191,0.6875 --at=0.522191,0.781514,0.8125 --at=0.921859,0.183369,1.5625 --at=0.921859,-0.183369,1.4375 --at=0.522191,-0.781514,1.1875 --at=0.781514,-0.522191,1.3125 --at=0.921859,-0.183369,0.4375 flatten --verbose info"
  ERR "points-on-surface +324\n.*boundary-triangles +724\n.*blocks-removed +76\ndoors-removed +138\n.*blocks-removed +76\ndoors-removed +138\n.*tetrahedra-kept +404\n.*blocks-removed +20\n.*tetrahedra-kept +384\n.*parts-flattened +384\n.*sheet-triangles +768\n"
  OUT "^points +425\ntriangles +768\n.*components +1\n.*manifold +yes\n.*euler-characteristic +1\n.*boundary-loops +1\n")
scan_cli_test(StoryOfTheHelixBySize "scanwrap $SHARED/synthetic/helix.xyz wrap --mode=classic --size=0.3 flatten info"
  OUT "^points +425\ntriangles +768\n.*components +1\n.*manifold +yes\n.*euler-characteristic +1\n.*boundary-loops +1\n")
scan_cli_test(StoryOfTheSaddle "scanwrap $SHARED/synthetic/monkey_saddle.xyz wrap --mode=classic flatten --verbose info"
  ERR "sheet-triangles +4476\n" OUT "^points +2340\n.*components +1\n.*manifold +yes\n.*euler-characteristic +1\n.*boundary-loops +1\n")
scan_cli_test(StoryOfTheSaddleInOneStep "scanwrap $SHARED/synthetic/monkey_saddle.xyz wrap --verbose info"
  ERR "\nopen +yes\n" OUT "^points +2340\n.*components +1\n.*manifold +yes\n.*euler-characteristic +1\n.*boundary-loops +1\n")

# Ten plates, turned, stretched and shaken, and one of them broken: a template made from the first one
# does them all in one batch, and the table tells what came out.
scan_cli_test(StoryOfTenPlates "mkdir plates && for i in 0 1 2 3 4 5 6 7 8 9; do awk -v i=$i 'BEGIN { srand(i); c = cos(i); s = sin(i); k = 1 + i / 3 } { e = i * 0.0005 * (rand() - 0.5); print k * (c * $1 - s * $2), k * (s * $1 + c * $2), k * $3 + e }' $DATA/plate_hole.xyz > plates/plate_$i.xyz; done && sed -i '100s/ .*//' plates/plate_7.xyz && scanwrap plates/plate_0.xyz thin --by=random --keep=97 --seed=2 wrap --mode=classic push --at=0,0,0 --deep repair-angles --quiet -o first.wrp && scanwrap first.wrp history --save-template=plate.txt && { scanwrap --batch='plates/*.xyz' --template=plate.txt -o 'out_{name}.stl' -o '{name}.wrp' --json=table.json --progress=none 2> err; echo status $?; for i in 0 1 2 3 4 5 6 8 9; do scanwrap out_plate_$i.stl info | grep -E '^genus'; scanwrap plate_$i.wrp | grep -c '[*] 5 '; done | sort | uniq -c; python3 -c 'import json; print([item[\"result\"] for item in json.load(open(\"table.json\"))[\"batch\"]].count(\"ok\"))'; }"
  FILES out_plate_0.stl out_plate_1.stl out_plate_2.stl out_plate_3.stl out_plate_4.stl out_plate_5.stl out_plate_6.stl out_plate_8.stl out_plate_9.stl
  OUT "plate_6.xyz +ok .*plate_7.xyz +failed +[0-9.]+  plates/plate_7.xyz: line 100: [^\n]*\nplates/plate_8.xyz +ok .*10 files: 9 ok, 1 failed\nstatus 1\n +9 1\n +9 genus +1\n9\n")
