# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
.PHONY: build demo test lint dependencies

demo: build
	@.ci/demo

test: build
	cmake --build build
	ctest --test-dir build --output-on-failure -j2

lint: dependencies
	cmake --preset release
	@.ci/lint

build: dependencies
	cmake --preset release
	cmake --build build --target scanwrap

dependencies:
	@.ci/install-dependencies
