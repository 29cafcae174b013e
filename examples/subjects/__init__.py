# SPDX-License-Identifier: Apache-2.0
"""The designed curves, one module per family of subjects."""
