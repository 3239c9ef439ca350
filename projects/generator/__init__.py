# SPDX-License-Identifier: MIT
"""Makes Soffit's sample projects; see projects/README.md."""
