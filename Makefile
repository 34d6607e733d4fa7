# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
.PHONY: build demo test dependencies

demo: build
	@.ci/demo

test: build
	cmake --build build
	ctest --test-dir build --output-on-failure -j2

build: dependencies
	cmake --preset release
	cmake --build build --target scanwrap

dependencies:
	@.ci/install-dependencies
