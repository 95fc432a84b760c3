#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs the whole test suite under one X server. Arguments go to ctest (say: -L filters).
set -eu

utilities=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
"$utilities/setup.sh"
exec "$utilities/with-xvfb.sh" ctest --test-dir "$(dirname -- "$utilities")/build/release" \
  --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
