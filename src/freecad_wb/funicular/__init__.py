# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form finding of compression-only gridshells: the numeric API. Needs numpy only; knows nothing of FreeCAD.

SI units (m, kg, N); up is +z; member forces are those of the built structure, compression negative.

The native module is loaded at the first use of a name, not at import: FreeCAD restores a document's objects
by importing this package, and must be able to do so, and keep their geometry, where that module is missing.
"""

_NUMERIC_API = (
    "AxialStiffness",
    "Certificate",
    "CoveringWeight",
    "Fixed",
    "InvalidInput",
    "Lattice",
    "LengthMatching",
    "MemberWeight",
    "Net",
    "OnLine",
    "OnPlane",
    "PointLoad",
    "Report",
    "Result",
    "Scene",
    "Snow",
    "Solver",
    "certify",
    "cell_extent",
    "lattice",
    "patterns",
    "solve",
    "solve_matching_lengths",
)

# What is written in Python on top of them, by module.
_IN_PYTHON = {
    "accuracy_study": "accuracy",
    "calibrate": "prediction",
    "cheapest": "cheapest_settings",
    "effect_study": "effect_costs",
    "net_error": "discretisation",
    "predict": "prediction",
}

__all__ = [*_NUMERIC_API, *_IN_PYTHON]


def __getattr__(name):
    if name in _IN_PYTHON:
        from importlib import import_module

        globals()[name] = getattr(import_module(f".{_IN_PYTHON[name]}", __name__), name)
        return globals()[name]
    if name not in _NUMERIC_API:
        raise AttributeError(f"module 'funicular' has no attribute {name!r}")
    from . import _native

    core = _native.load()
    _give_files_to(core.Net, core.InvalidInput)
    for public in _NUMERIC_API:
        globals()[public] = getattr(core, public)
    return globals()[name]


def _give_files_to(net_class, refusal):
    """Hangs reading and writing of files, which the core knows nothing of, on the core's Net."""
    from . import files

    def read(path):
        try:
            return net_class(*files.read_mesh(path))
        except ValueError as error:
            # The readers name the file; the net, which may refuse what they read, knows of none.
            named = str(error).startswith(str(path))
            raise refusal(str(error) if named else f"{path}: {error}") from error

    def write(net, path):
        files.write_mesh(path, net.nodes, net.members, net.panels)

    read.__doc__ = "The net in an .obj, .ply, .stl or .off file, in metres; see `funicular.files`."
    write.__doc__ = "Writes the net to an .obj, .ply, .stl or .off file, in metres; see `funicular.files`."
    net_class.read = staticmethod(read)
    net_class.write = write


def __dir__():
    return sorted(set(globals()) | set(__all__))
