# SPDX-License-Identifier: Apache-2.0
"""Turns designed curves into pen strokes and writes them as SVG."""
