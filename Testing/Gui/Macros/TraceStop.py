# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ends the trace, and writes it to trace.py."""

from paraview import smtrace

with open("trace.py", "w", encoding="utf-8") as script:
    script.write(smtrace.stop_trace())
