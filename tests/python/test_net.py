# SPDX-License-Identifier: LGPL-2.1-or-later
"""Net and lattice from Python: shapes, dtypes, memory layouts, and errors that name argument and index."""

import numpy as np
import pytest

import funicular as fn

NODES = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
MEMBERS = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])


def test_arrays_have_the_promised_shape_and_type():
    net = fn.Net(NODES, MEMBERS, [[0, 1, 2, 3]])
    assert net.nodes.shape == (4, 3) and net.nodes.dtype == np.float64
    assert net.members.shape == (4, 2) and np.issubdtype(net.members.dtype, np.integer)
    assert net.panels == ((0, 1, 2, 3),)
    assert net.source_lengths.shape == (4,)
    assert net.border.tolist() == [0, 1, 2, 3]
    assert net.lattice is None
    np.testing.assert_array_equal(net.nodes, NODES)
    np.testing.assert_array_equal(net.members, MEMBERS)


@pytest.mark.parametrize("name", ["nodes", "members", "source_lengths", "border"])
def test_arrays_cannot_be_written(name):
    array = getattr(fn.Net(NODES, MEMBERS, [[0, 1, 2, 3]]), name)
    with pytest.raises(ValueError, match="read-only"):
        array[0] = 7


def test_arrays_outlive_the_net():
    nodes = fn.Net.grid(4, 4, 1).nodes
    others = [fn.Net.grid(4, 4, 1) for _ in range(50)]
    np.testing.assert_array_equal(nodes, others[0].nodes)


def test_the_net_keeps_a_copy_of_what_it_is_given():
    nodes = NODES.copy()
    net = fn.Net(nodes, MEMBERS)
    nodes[0] = 99
    np.testing.assert_array_equal(net.nodes, NODES)


@pytest.mark.parametrize(
    "nodes",
    [
        NODES.tolist(),
        NODES.astype(np.float32),
        NODES.astype(int),
        np.asfortranarray(NODES),
        np.repeat(NODES, 2, axis=0)[::2],
        np.hstack([NODES, NODES])[:, :3],
        NODES[::-1][::-1],
    ],
    ids=["list", "float32", "int", "fortran", "strided_rows", "strided_columns", "negative_strides"],
)
def test_any_layout_of_nodes_is_understood(nodes):
    np.testing.assert_array_equal(fn.Net(nodes, MEMBERS).nodes, NODES)


@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint16, np.uint64])
def test_any_integer_type_of_members_is_understood(dtype):
    np.testing.assert_array_equal(fn.Net(NODES, np.asfortranarray(MEMBERS.astype(dtype))).members, MEMBERS)


def with_value(array, index, value):
    changed = np.array(array, dtype=float)
    changed[index] = value
    return changed


@pytest.mark.parametrize(
    "arguments, words",
    [
        (([], MEMBERS), ["nodes is empty"]),
        ((NODES[:, :2], MEMBERS), ["nodes", "(n, 3)", "(4, 2)"]),
        ((NODES[0], MEMBERS), ["nodes", "(n, 3)", "(3,)"]),
        ((with_value(NODES, (2, 1), np.nan), MEMBERS), ["nodes[2]", "finite"]),
        ((with_value(NODES, (1, 0), np.inf), MEMBERS), ["nodes[1]", "finite"]),
        ((NODES.astype(str), MEMBERS), ["nodes", "real numbers"]),
        ((NODES.astype(complex), MEMBERS), ["nodes", "real numbers"]),
        ((None, MEMBERS), ["nodes", "real numbers"]),
        ((NODES, []), ["members is empty"]),
        ((NODES, [0, 1, 2]), ["members", "(m, 2)", "(3,)"]),
        ((NODES, MEMBERS.astype(float)), ["members", "integers"]),
        ((NODES, [[0, 1], [1, 4]]), ["members[1]", "node 4", "0 to 3"]),
        ((NODES, [[0, 1], [1, -1]]), ["members[1]", "-1"]),
        ((NODES, [[0, 1], [1, 2**40]]), ["members[1]"]),
        ((NODES, [[0, 1], [2, 2]]), ["members[1]", "itself"]),
        ((NODES, [[0, 1], [1, 2], [1, 0]]), ["members[2]", "members[0]"]),
        ((NODES, MEMBERS, [[0, 1]]), ["panels[0]", "three"]),
        ((NODES, MEMBERS, [[0, 1, 2], [0, 1, 9]]), ["panels[1]", "node 9"]),
        ((NODES, MEMBERS, [[0, 1, 2], [0.0, 1.0, 2.0]]), ["panels[1]", "integers"]),
        ((NODES, MEMBERS, 3), ["panels", "sequence"]),
    ],
)
def test_errors_name_the_argument_and_the_first_offending_index(arguments, words):
    with pytest.raises(fn.InvalidInput) as caught:
        fn.Net(*arguments)
    assert isinstance(caught.value, ValueError)
    for word in words:
        assert word in str(caught.value)


def test_grid_remembers_its_lattice():
    net = fn.Net.grid(8.0, 6.0, step=0.5, pattern="quad")
    assert net.lattice.cells == (16, 12)
    assert net.nodes.shape == (17 * 13, 3)
    assert net.nodes.max(axis=0).tolist() == [8, 6, 0]
    for arguments in ((8, 6, 0), (8, 6, 7), (8, 6, -1), (8, 6, np.nan), (-8, 6, 1), (8, 6, 1, "penrose")):
        with pytest.raises(fn.InvalidInput):
            fn.Net.grid(*arguments)


def test_lattice_of_a_dome():
    lattice = fn.lattice(6, 3, closed_u=True, poles=["v_max"])
    assert lattice.uv.shape == (19, 2)
    assert lattice.corners.size == 0
    assert list(lattice.sides) == ["v_min"]
    assert lattice.sides["v_min"].tolist() == [0, 1, 2, 3, 4, 5]
    assert lattice.closed == (True, False) and lattice.poles == ["v_max"]
    net = lattice.net(np.column_stack([lattice.uv, np.zeros(19)]) + np.arange(19)[:, None])
    assert net.lattice is not None
    with pytest.raises(fn.InvalidInput, match="nodes has 3 rows"):
        lattice.net(np.zeros((3, 3)))
    with pytest.raises(fn.InvalidInput, match="pattern 'spiral'"):
        fn.lattice(3, 3, pattern="spiral")
    with pytest.raises(fn.InvalidInput, match="left"):
        fn.lattice(3, 3, poles=["left"])


def test_files_through_the_net(tmp_path):
    net = fn.Net.grid(4, 3, 1)
    for suffix in (".obj", ".ply", ".off"):
        path = tmp_path / f"sheet{suffix}"
        net.write(path)
        again = fn.Net.read(path)
        np.testing.assert_array_equal(again.nodes, net.nodes)
        assert again.panels == net.panels
        edges = {tuple(sorted(edge)) for edge in net.members.tolist()}
        assert {tuple(sorted(edge)) for edge in again.members.tolist()} == edges
