# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many random examples: the same few hundred in `make test`, others every time in `make soak`."""

from hypothesis import HealthCheck, settings

# A solve takes what it takes, and the first example also loads the module; many examples are refused scenes.
_EITHER = {
    "deadline": None,
    "print_blob": True,
    "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much, HealthCheck.data_too_large],
}
settings.register_profile("test", max_examples=100, derandomize=True, database=None, **_EITHER)
settings.register_profile("soak", max_examples=200, **_EITHER)
settings.load_profile("test")
