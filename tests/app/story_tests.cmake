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
