<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>(u, v) of each node that is on no lattice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>(u, v) of the face between 0 and 1 (z is not used): the node nearest to each</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>(u, v) of the face, between 0 and 1, that a net of equal lengths grows from</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>(u, v) on the face: the nearest member is taken out, and the panels beside it are one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>(u, v) on the face: the nearest panel becomes an opening</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>(u, v, height in mm): the node nearest to (u, v) on the face is raised, or lowered</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>A mesh file (obj, ply, stl, off) that is taken as it is, where there is no source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Along the isolines of the face, or with a compass, so that all members have the length of StepU</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Area of each opening on the source [mm²]</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Area that the covering's weight counts: of triangles about the mean of each panel's corners</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Between members at the start</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>By how many cells the pattern is shifted along u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>By how many cells the pattern is shifted along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>By how much each of RaisedNodes is raised [mm]</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>By which the pattern is turned on the face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cells along u, in place of StepU; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cells along v, in place of StepV; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Colour each member by its force</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Curved edges are divided into parts no longer than this; 0 for one member each</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>EA of the members, the force that would double their length: the lower, the higher the shell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges and vertices of the net's source, such as Edge3 or Vertex1: every node on them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges and vertices of the source that hold nodes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Faces: plane where a panel is plane, ruled on warped quads, triangles on other warped panels; Ruled faces: ruled on every quad; Triangles: between edges and the mean of the corners</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Force for each length that the support yields; 0 for one that does not</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Force in each member [N], compression negative</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Give up after this time; 0 for never</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How a panel's weight goes to its corners: by their angles, equally, by the area nearest to each</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far a corner may lie from the best plane of a panel that counts as plane</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far from equilibrium the nodes may lie</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far the angle between members may be from a right one; there the net ends</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far the nodes still are from equilibrium</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How members are laid on the face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How nodes are held; Free takes them from the other supports</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the last recompute ended: converged; failed; or the limit that the solver met</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Iterations of the solver</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest distance of a corner from its best plane</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest unbalanced force at a node, in mean nodal loads</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lay the pattern over the mesh of File by its UV coordinates, instead of taking its own edges</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length of members along u, measured on the face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length of members along v, measured on the face</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Let members carry tension too; otherwise those that would go slack</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members in tension, counted from 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members that are taken out, by number</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members without force: they can be left out</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Newton is fast; relaxation is the method of Brivio et al. (2009); auto chooses</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>No member is in tension: recomputed from the result</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Nodes on the face, in the numbering of the net</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Normal of the plane, or direction of the line</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of cells along u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of cells along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of members</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of nodes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of panels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Number of panels that are plane</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Numbers of nodes before edits, for a net that keeps them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Numbers of nodes, for nets that keep them</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of a flat sheet, where there is no source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of each border of a hole how many nodes, then these</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of each how many nodes, then their numbers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of each opening how many nodes, then their numbers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Of each panel how many nodes, then their numbers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Panels that are not plane, counted from 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Panels that become openings, by number</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Reaction at each node [N], before Placement; zero where unsupported</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Relaxed position of each node [mm], before Placement</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Root mean square of the members' relative difference from their lengths on the source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Rounds that bring the members back to their lengths on the source; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Show what force each colour stands for</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Sides of the face that are one point</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Snow load on plan; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Sum of all loads, downwards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Sum of all reactions, upwards</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Supports of their own, besides those of the recipe</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The face or faces that the net lies on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The gridshell whose panels these are</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The last cell along u joins the first</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The last cell along v joins the first</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The method that found the result</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The net that is relaxed; several gridshells may share one</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The net whose nodes are held</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The nodes around each panel: of each panel how many, then their numbers</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The nodes of each member: two numbers a member, counted from 0</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The pattern that the nodes were laid in</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The result in a sentence</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Time in the solver</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Turn the pattern: what ran along u runs along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Two nodes a member; empty for a lattice</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Unit of the lengths in File</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Version of the set of properties of this object</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Vertices of a mesh as near as this are one node; 0 for 1e-6 of its size</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Weight of the covering per area; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Weight of the members per length; 0 for none</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What came out otherwise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What each of SourceElements is</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What is equal from cell to cell: the length on the face, or the surface's parameters</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What the elements were when they were picked</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What the face belonged to when it was picked</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What this object is to Funicular</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What was found</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What was kept of this gridshell under a name, see funicular.features.variants</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Where the shell stands</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether that was turned</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Which node each was before edits; empty if the same</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Which nodes are held</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular</name>
        <message>
            <source>(The last good shape stays.)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>, with EA and weight of members times {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>, {} slack</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>. Select another face and press “Use selected faces”.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Accuracy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Allow tension</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Along isolines</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Alternating</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Alternatives</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Angle</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it is an undo step.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it was taken back.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Another dialog is open in the task panel. Close it, then edit the gridshell.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Auto</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Back to {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Begin again from the net as it lies on its source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Boundary</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Brick</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>But its panels have shrunk to {} % of their area, as where one point holds all: choose other supports</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cancel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cancelled; what was measured stays.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cells along u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Cells along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Centred</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Choose one alternative, then restore it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Choose one to see it, two (with Ctrl) to compare them; F2 renames. Without a choice the present form is shown.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Click a point: the gridshell takes its accuracy and method.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Close the panel that is open, then click the point again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Compression only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Compression only, at most {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Corners</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Corners and border planes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Covering</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Crossed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Crossing</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Delete</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Depth</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Diagonal</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Diagrid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Divide curves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Do without, or end it while it goes on</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edges and vertices</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Edit gridshell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Equal</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Equal in</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Equal lengths</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Faces of {} bodies are selected: select one or more of a single body in the 3D view, then press again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Finding the shape to measure against</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Fixed</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Flat sheet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Follows the expression {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Force +</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Force −</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Forget the chosen alternative</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Free</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Full lines: how far the nodes truly are from where they stand in equilibrium. Dashed lines: how far the solver says they are. Farther right is more accurate, lower is faster.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Funicular</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Funicular guide</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Go on from the inputs of the chosen alternative</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Gridshell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Hexagon</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far the farthest node is from where it was laid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far the nodes are from where they were laid, on the average</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How the solve went, against time. Full line: distance from equilibrium, dashed: largest unbalanced force. The level line is what is asked for: below it a curve has arrived.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Its unit</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Kagome</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Keep this</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Keep this form under a name</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Laid</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest compression in a member</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lay the net on the faces that are selected in the 3D view</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lay the pattern</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Leave them out</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length matching</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length matching was left out: each of its rounds is one more solve.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Length of the longest member</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lengths differ by {} % → {} % (rms), best reached after {} rounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lengths differ from those on the source by {} % (rms)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Less than {} mm from equilibrium</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Longest</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Lowest points</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Match lengths</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Matching lengths, {} rounds</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Matplotlib draws with another Qt than FreeCAD's, as some addon has asked of it: start FreeCAD again, and use Funicular before that addon.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measure again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measure the gridshell as it is now</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measuring</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measuring {} by {}, {} of {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Member force</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members and supports</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Members up to {} times as long as on the face: stiffer ones stretch less</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Mesh file</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Method</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>More of the net</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Most shear</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Net</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Newton</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Nodes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>None</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Nothing to build on is selected. Select a face in the 3D view, or several of one body, then run Gridshell again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Off, mean</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Off, most</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>On a line</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>On a plane</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>On its vertical line</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>On its vertical plane</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>One iteration of the solver more, then a pause</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Opening rims</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Other diagonal</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parameter</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Parts of {} gridshells are selected: select nodes or members of one in the 3D view.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Pattern</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Pause</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Paused</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Points</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Properties to change: {}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Pure</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Quad</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Raise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Relax slowly</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Relaxation</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Reset</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Restore</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Resume</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ribs u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ribs v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Rise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ruled faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Save as…</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Save what was measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select a gridshell and press “What accuracy costs”.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Select either nodes of the gridshell or edges of its source, and make one support of each.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shared by</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shift along u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shift along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Shorten what has become longer than on the source and lengthen what has become shorter, round by round, as far as equilibrium lets it</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Show</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Snow</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Solution</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Solve once more without each effect: how much time it takes, and how far the shape moves. Nothing is left out by this.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Solving</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Source</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Start (u, v)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Step along u</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Step along v</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Stiffness EA</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Stop measuring; what was measured stays</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Support</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Supports</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Table, and a picture of the same name (*.csv)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Take out</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Ten times as stiff</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>That is less than {}: it may be left out.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The gridshell has changed since this was begun: press “Measure again”.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The guide is missing: {}. Install the addon again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The members cannot carry these loads.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Together these may move it by {}: leave out one, then measure again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Triangle</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Triangles</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Turned</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Undo and redo end the panel of {}: its inputs no longer hold.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Undo matching</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Use selected faces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Variant {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Voronoi</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Wait until the form has settled, then keep it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Watch how the net comes to hang by the relaxation of Brivio et al. (2009), step by step, instead of the fast solver. What it comes to is the same.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Weight</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Weights</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Weld within</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What a solve to this accuracy takes, as predicted. Below it the largest step that brings the net as near to the smooth surface that it stands for, which is no error where members are the straight beams that will be built.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What accuracy costs: {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What effects cost</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Whether it stands in compression only</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Width</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Without it {}, and the shape moves by {}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Write what was measured as a table (.csv) and a picture (.png)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Zigzag</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>about {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>accuracy now: {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>asked for: {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>by step</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>cancelled</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>change</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>compression −</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>compression − (own scale)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>distance from equilibrium</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>no</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>off</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>point loads</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>present</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>residual {:.0e}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>snow</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>tension +</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>tension + (own scale)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>the covering</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>the members' stiffness</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>the members' weight</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>the solve was cancelled and the last good shape stays; recompute to solve again</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>time in the solver</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>yes</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} % faster</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} % slower</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} Accuracy and method are as before.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} and {} are written.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} bodies or nets are selected, and a gridshell stands on one. Select faces of a single body in the 3D view, then run Gridshell again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} by {}: {}, truly {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} follows the expression {}: change that instead.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} gave up after {}, without coming as near as {}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} gridshells are selected, and this is done for one. Select a single Gridshell in the tree, then run the command again.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} has another net: restore it to see it.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} is selected as a whole, with {} faces: select those that the gridshell shall follow, in the 3D view.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} is there already. Replace it?</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} members are in tension.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} members are slack: they carry nothing.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} mm from equilibrium</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} of {} is not what the net lies on: select edges of its source.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} of {} measured</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} of {} members in tension, at most {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} overall: step {}, {}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} supports pull the shell down, so it pulls upward there.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{} total, balanced to {:.0e}</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{}, {} iterations</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{}. Chosen: the gridshell was solved again in {}.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{}. The gridshell has this accuracy and method.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{}: {} %, Esc cancels</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>{}: {}, {} % of the time, {} calls, {} kB.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>“{}” is not a value in {}. Write for example “12 {}”.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>FunicularPreferences</name>
        <message>
            <source>&amp;Accuracy</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>&amp;Colours of forces</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>&amp;Time for a frame</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>As the unit schema (N and kN, or lbf and kip)</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Blue for compression, orange for tension</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>From one frame to the next while a form moves; more leaves more of the processor to the solver. Counts from the next time that a panel opens.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>General</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>How far from equilibrium the nodes of a new gridshell may lie</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>New gridshells</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Numbers and colours</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>One ramp, from dark to light</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Panel of a gridshell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Show the form as it &amp;moves</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Show the form on its way, at an even pace. Without it each form is shown where it comes to.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The colours of the members in the 3D view. Both are told apart with any colour vision.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The unit that forces are written in: in sentences, in the legend and in the panel</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Unit of &amp;force</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_AccuracyStudy</name>
        <message>
            <source>A plot grows beside the 3D view, and nothing waits for it. Click a point of it, and the gridshell takes that accuracy and method.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Measure how long the selected gridshell takes at several accuracies, and choose one.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Covering</name>
        <message>
            <source>Cover the panels of the selected gridshell with faces.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Covering</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Each panel becomes a face that other commands of FreeCAD can use and that STEP files take. The Covering says which panels are warped and by how much, and follows the gridshell.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Gridshell</name>
        <message>
            <source>A net is laid on the face and relaxed until each member is compressed. The panel that opens has its steps, weights and supports. Shape and numbers follow the face from then on.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Gridshell</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Turn the selected face into a compression-only gridshell.
Select a face in the 3D view, several of one body, or a Net in the tree, then run this command.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Guide</name>
        <message>
            <source>Funicular guide</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The guide opens in a window of its own and needs no network.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Two pages with pictures: from a face to a gridshell and out.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Raise</name>
        <message>
            <source>Raise</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Raise the selected nodes of the net by a quarter of a member, and again for more.
Select nodes of a Gridshell. The height of each is in the property Raised of its Net.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The gridshell is relaxed again on the net that was changed. Undo takes it back.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Sheet</name>
        <message>
            <source>Flat sheet</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Start from a flat sheet of given size, which rises between its four corners.
Nothing needs to be selected.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The sheet stands on its four corners and rises between them. The panel that opens has its width, its depth and all else that a gridshell has.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_Support</name>
        <message>
            <source>Hold the selected gridshell at its border, or where edges and vertices are selected too.
Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Support</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The new Support stands in the tree, and its properties say how it holds its nodes: fixed, sliding in a plane or on a line, yielding, or not at all. It outlives other steps of the net.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Funicular_TakeOut</name>
        <message>
            <source>Take out</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Take the selected members out of the net, or the panels whose faces are selected.
Select members of a Gridshell, or faces of its Covering. Their place on the face is kept.</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>The covering of an opening stands on its rim. The gridshell is relaxed again. Undo takes it back.</source>
            <translation type="unfinished" />
        </message>
    </context>
    <context>
        <name>Workbench</name>
        <message>
            <source>Funicular</source>
            <translation type="unfinished" />
        </message>
        <message>
            <source>Turn a surface into a compression-only gridshell</source>
            <translation type="unfinished" />
        </message>
    </context>
</TS>
