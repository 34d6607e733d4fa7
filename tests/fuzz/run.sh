#!/bin/sh
# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs the fuzzers of the parsers, two at a time:
#   tests/fuzz/run.sh SECONDS [PARSER...]
# Each starts from its folder in tests/fuzz/corpus. What it finds new goes to build/fuzz/grown/PARSER,
# files that break a parser to build/fuzz/broken/PARSER-*. Fails when there is one.
set -eu
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [PARSER...]}
shift
cd "$(dirname "$0")/../.."
cmake --preset fuzz > /dev/null
cmake --build --preset fuzz
mkdir -p build/fuzz/broken
[ $# -gt 0 ] || set -- $(find build/fuzz/fuzz -maxdepth 1 -type f -exec basename {} \; | sort)
export ASAN_OPTIONS="quarantine_size_mb=16:malloc_context_size=10" UBSAN_OPTIONS="print_stacktrace=1"
printf '%s\n' "$@" | xargs -P 2 -I NAME sh -c '
  mkdir -p build/fuzz/grown/NAME
  case NAME in step | iges) most=60 ;; *) most=5 ;; esac # seconds: small CAD files may be much work
  nice build/fuzz/fuzz/NAME -max_total_time='"$seconds"' -timeout=$most -rss_limit_mb=1024 \
    -malloc_limit_mb=256 -max_len=6000 -print_final_stats=1 \
    -artifact_prefix=build/fuzz/broken/NAME- \
    build/fuzz/grown/NAME tests/fuzz/corpus/NAME > build/fuzz/NAME.log 2>&1 ||
  { echo "NAME is broken, see build/fuzz/NAME.log" && exit 1; }'
