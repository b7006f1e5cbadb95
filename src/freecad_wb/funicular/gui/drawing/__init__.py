# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn of a gridshell in the 3D view beside its shape: coin nodes below its view provider."""
