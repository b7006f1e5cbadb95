<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>(u, v) of each node that is on no lattice</source>
            <translation>(u, v) jedes Knotens, der auf keinem Raster liegt</translation>
        </message>
        <message>
            <source>(u, v) of the face between 0 and 1 (z is not used): the node nearest to each</source>
            <translation type="vanished">(u, v) der Fläche zwischen 0 und 1 (z zählt nicht): der jeweils nächste Knoten</translation>
        </message>
        <message>
            <source>(u, v) of the face, between 0 and 1, that a net of equal lengths grows from</source>
            <translation>(u, v) der Fläche, zwischen 0 und 1, wo ein Netz gleicher Stablängen beginnt</translation>
        </message>
        <message>
            <source>(u, v) on the face: the nearest member is taken out, and the panels beside it are one</source>
            <translation>(u, v) auf der Fläche: der nächste Stab entfällt, die Felder neben ihm werden eines</translation>
        </message>
        <message>
            <source>(u, v) on the face: the nearest panel becomes an opening</source>
            <translation>(u, v) auf der Fläche: das nächste Feld wird eine Öffnung</translation>
        </message>
        <message>
            <source>(u, v, height in mm): the node nearest to (u, v) on the face is raised, or lowered</source>
            <translation>(u, v, Höhe in mm): der Knoten, der (u, v) auf der Fläche am nächsten liegt, wird gehoben oder gesenkt</translation>
        </message>
        <message>
            <source>A mesh file (obj, ply, stl, off) that is taken as it is, where there is no source</source>
            <translation>Eine Netzdatei (obj, ply, stl, off), die genommen wird, wie sie ist, wenn es keine Quelle gibt</translation>
        </message>
        <message>
            <source>Along the isolines of the face, or with a compass, so that all members have the length of StepU</source>
            <translation>Entlang der Isolinien der Fläche, oder mit dem Zirkel, sodass alle Stäbe so lang sind wie StepU</translation>
        </message>
        <message>
            <source>Area of each opening on the source [mm²]</source>
            <translation>Fläche jeder Öffnung auf der Quelle [mm²]</translation>
        </message>
        <message>
            <source>Area that the covering's weight counts: of triangles about the mean of each panel's corners</source>
            <translation>Fläche, die für das Gewicht der Eindeckung zählt: die von Dreiecken um die Mitte der Ecken jedes Feldes</translation>
        </message>
        <message>
            <source>Between members at the start</source>
            <translation>Zwischen den Stäben am Anfang</translation>
        </message>
        <message>
            <source>By how many cells the pattern is shifted along u</source>
            <translation>Um wie viele Zellen das Muster entlang u verschoben ist</translation>
        </message>
        <message>
            <source>By how many cells the pattern is shifted along v</source>
            <translation>Um wie viele Zellen das Muster entlang v verschoben ist</translation>
        </message>
        <message>
            <source>By how much each of RaisedNodes is raised [mm]</source>
            <translation>Um wie viel jeder der RaisedNodes gehoben wird [mm]</translation>
        </message>
        <message>
            <source>By which the pattern is turned on the face</source>
            <translation>Um den das Muster auf der Fläche gedreht ist</translation>
        </message>
        <message>
            <source>Cells along u, in place of StepU; 0 for none</source>
            <translation>Zellen entlang u, anstelle von StepU; 0 für keine Vorgabe</translation>
        </message>
        <message>
            <source>Cells along v, in place of StepV; 0 for none</source>
            <translation>Zellen entlang v, anstelle von StepV; 0 für keine Vorgabe</translation>
        </message>
        <message>
            <source>Colour by the range that is given, unless its ends are equal</source>
            <translation>Nach dem vorgegebenen Bereich färben, außer wenn seine Enden gleich sind</translation>
        </message>
        <message>
            <source>Curved edges are divided into parts no longer than this; 0 for one member each</source>
            <translation>Gekrümmte Kanten werden in Teile geteilt, die nicht länger sind als dies; 0 für je einen Stab</translation>
        </message>
        <message>
            <source>Diameter of round bars, and width of rectangular ones</source>
            <translation type="vanished">Durchmesser runder Stäbe und Breite rechteckiger</translation>
        </message>
        <message>
            <source>Diameter of round bars, width of others; where such a section is given, its own</source>
            <translation>Durchmesser runder Stäbe, Breite der anderen; ist ein solcher Querschnitt angegeben, dessen Maß</translation>
        </message>
        <message>
            <source>Diameter of round members, width of others</source>
            <translation>Durchmesser runder Stäbe, Breite anderer</translation>
        </message>
        <message>
            <source>EA of the members, the force that would double their length: the lower, the higher the shell</source>
            <translation>EA der Stäbe, die Kraft, die ihre Länge verdoppeln würde: je kleiner, desto höher die Schale</translation>
        </message>
        <message>
            <source>Edges and vertices of the net's source, such as Edge3 or Vertex1: every node on them</source>
            <translation type="vanished">Kanten und Eckpunkte der Quelle des Netzes, etwa Edge3 oder Vertex1: jeder Knoten darauf</translation>
        </message>
        <message>
            <source>Edges and vertices of the source that hold nodes</source>
            <translation>Kanten und Eckpunkte der Quelle, auf denen Knoten liegen</translation>
        </message>
        <message>
            <source>Faces: plane where a panel is plane, ruled on warped quads, triangles on other warped panels; Ruled faces: ruled on every quad; Triangles: between edges and the mean of the corners</source>
            <translation>Faces: eben, wo ein Feld eben ist, Regelflächen auf verwundenen Vierecken, Dreiecke auf anderen verwundenen Feldern; Ruled faces: Regelflächen auf allen Vierecken; Triangles: zwischen den Kanten und der Mitte der Ecken</translation>
        </message>
        <message>
            <source>Force for each length that the support yields; 0 for one that does not</source>
            <translation type="vanished">Kraft je Länge, um die das Auflager nachgibt; 0 für eines, das nicht nachgibt</translation>
        </message>
        <message>
            <source>Force in each member [N], compression negative</source>
            <translation>Kraft in jedem Stab [N], Druck negativ</translation>
        </message>
        <message>
            <source>Forces on single nodes, besides all weights</source>
            <translation>Kräfte auf einzelne Knoten, neben allen Gewichten</translation>
        </message>
        <message>
            <source>Give up after this time; 0 for never</source>
            <translation>Nach dieser Zeit aufgeben; 0 für nie</translation>
        </message>
        <message>
            <source>Height of rectangular bars, in the vertical plane of each</source>
            <translation type="vanished">Höhe rechteckiger Stäbe, jeweils in ihrer lotrechten Ebene</translation>
        </message>
        <message>
            <source>Height of rectangular bars, upright; where such a section is given, its own</source>
            <translation>Höhe rechteckiger Stäbe, aufrecht; ist ein solcher Querschnitt angegeben, dessen Höhe</translation>
        </message>
        <message>
            <source>Height of rectangular members</source>
            <translation>Höhe rechteckiger Stäbe</translation>
        </message>
        <message>
            <source>How a panel's weight goes to its corners: by their angles, equally, by the area nearest to each</source>
            <translation>Wie das Gewicht eines Feldes auf seine Ecken kommt: nach ihren Winkeln, zu gleichen Teilen, nach der Fläche, die jeder am nächsten liegt</translation>
        </message>
        <message>
            <source>How far a corner may lie from the best plane of a panel that counts as plane</source>
            <translation>Wie weit eine Ecke von der Ausgleichsebene eines Feldes liegen darf, das als eben gilt</translation>
        </message>
        <message>
            <source>How far from equilibrium the nodes may lie</source>
            <translation>Wie weit die Knoten vom Gleichgewicht entfernt sein dürfen</translation>
        </message>
        <message>
            <source>How far the angle between members may be from a right one; there the net ends</source>
            <translation>Wie weit der Winkel zwischen den Stäben vom rechten abweichen darf; dort endet das Netz</translation>
        </message>
        <message>
            <source>How far the nodes still are from equilibrium</source>
            <translation>Wie weit die Knoten noch vom Gleichgewicht entfernt sind</translation>
        </message>
        <message>
            <source>How high the sun stands above the horizon; below 5° it is taken for 5°</source>
            <translation>Wie hoch die Sonne über dem Horizont steht; unter 5° gilt 5°</translation>
        </message>
        <message>
            <source>How many times larger than it is the way from the source is drawn: 1 to 20</source>
            <translation>Wie vielfach vergrößert der Weg von der Quelle gezeichnet wird: 1 bis 20</translation>
        </message>
        <message>
            <source>How members are laid on the face</source>
            <translation>Wie die Stäbe auf der Fläche liegen</translation>
        </message>
        <message>
            <source>How nodes are held; Free takes them from the other supports</source>
            <translation type="vanished">Wie Knoten gehalten werden; Free nimmt sie den anderen Auflagern</translation>
        </message>
        <message>
            <source>How the last recompute ended: converged; failed; or the limit that the solver met</source>
            <translation>Wie die letzte Berechnung endete: converged; failed; oder die Grenze, an die der Löser stieß</translation>
        </message>
        <message>
            <source>Iterations of the solver</source>
            <translation>Iterationen des Lösers</translation>
        </message>
        <message>
            <source>Largest distance of a corner from its best plane</source>
            <translation>Größter Abstand einer Ecke von ihrer Ausgleichsebene</translation>
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation>Größter Zug in einem Stab</translation>
        </message>
        <message>
            <source>Largest unbalanced force at a node, in mean nodal loads</source>
            <translation>Größte unausgeglichene Kraft an einem Knoten, in mittleren Knotenlasten</translation>
        </message>
        <message>
            <source>Lay the pattern over the mesh of File by its UV coordinates, instead of taking its own edges</source>
            <translation>Das Muster anhand der UV-Koordinaten über das Netz der Datei legen, statt dessen eigene Kanten zu nehmen</translation>
        </message>
        <message>
            <source>Length of members along u, measured on the face</source>
            <translation>Länge der Stäbe entlang u, auf der Fläche gemessen</translation>
        </message>
        <message>
            <source>Length of members along v, measured on the face</source>
            <translation>Länge der Stäbe entlang v, auf der Fläche gemessen</translation>
        </message>
        <message>
            <source>Let members carry tension too; otherwise those that would go slack</source>
            <translation>Stäbe dürfen auch Zug aufnehmen; sonst würden solche schlaff</translation>
        </message>
        <message>
            <source>Members in tension, counted from 0</source>
            <translation>Stäbe unter Zug, ab 0 gezählt</translation>
        </message>
        <message>
            <source>Members that are taken out, by number</source>
            <translation>Stäbe, die entfallen, nach Nummer</translation>
        </message>
        <message>
            <source>Members without force: they can be left out</source>
            <translation>Stäbe ohne Kraft: sie können entfallen</translation>
        </message>
        <message>
            <source>Newton is fast; relaxation is the method of Brivio et al. (2009); auto chooses</source>
            <translation>Newton ist schnell; Relaxation ist das Verfahren von Brivio et al. (2009); Auto wählt aus</translation>
        </message>
        <message>
            <source>No member is in tension: recomputed from the result</source>
            <translation>Kein Stab steht unter Zug: aus dem Ergebnis neu berechnet</translation>
        </message>
        <message>
            <source>Nodes on the face, in the numbering of the net</source>
            <translation>Knoten auf der Fläche, in der Nummerierung des Netzes</translation>
        </message>
        <message>
            <source>Normal of the plane, or direction of the line</source>
            <translation type="vanished">Normale der Ebene oder Richtung der Linie</translation>
        </message>
        <message>
            <source>Number of cells along u</source>
            <translation>Anzahl der Zellen entlang u</translation>
        </message>
        <message>
            <source>Number of cells along v</source>
            <translation>Anzahl der Zellen entlang v</translation>
        </message>
        <message>
            <source>Number of members</source>
            <translation>Anzahl der Stäbe</translation>
        </message>
        <message>
            <source>Number of nodes</source>
            <translation>Anzahl der Knoten</translation>
        </message>
        <message>
            <source>Number of panels</source>
            <translation>Anzahl der Felder</translation>
        </message>
        <message>
            <source>Number of panels that are plane</source>
            <translation>Anzahl der ebenen Felder</translation>
        </message>
        <message>
            <source>Numbers of nodes before edits, for a net that keeps them</source>
            <translation type="vanished">Nummern von Knoten vor Änderungen, für ein Netz, das sie behält</translation>
        </message>
        <message>
            <source>Numbers of nodes, for nets that keep them</source>
            <translation>Nummern von Knoten, für Netze, die sie behalten</translation>
        </message>
        <message>
            <source>Of a flat sheet, where there is no source</source>
            <translation>Eines ebenen Netzes, wenn es keine Quelle gibt</translation>
        </message>
        <message>
            <source>Of each border of a hole how many nodes, then these</source>
            <translation>Für jeden Lochrand, wie viele Knoten, dann diese</translation>
        </message>
        <message>
            <source>Of each how many nodes, then their numbers</source>
            <translation>Jeweils wie viele Knoten, dann ihre Nummern</translation>
        </message>
        <message>
            <source>Of each opening how many nodes, then their numbers</source>
            <translation>Für jede Öffnung, wie viele Knoten, dann ihre Nummern</translation>
        </message>
        <message>
            <source>Of each panel how many nodes, then their numbers</source>
            <translation>Für jedes Feld, wie viele Knoten, dann ihre Nummern</translation>
        </message>
        <message>
            <source>Panels that are not plane, counted from 0</source>
            <translation>Felder, die nicht eben sind, ab 0 gezählt</translation>
        </message>
        <message>
            <source>Panels that become openings, by number</source>
            <translation>Felder, die zu Öffnungen werden, nach Nummer</translation>
        </message>
        <message>
            <source>Reaction at each node [N], before Placement; zero where unsupported</source>
            <translation>Auflagerkraft an jedem Knoten [N], vor der Platzierung; null, wo kein Auflager ist</translation>
        </message>
        <message>
            <source>Relaxed position of each node [mm], before Placement</source>
            <translation>Lage jedes Knotens im Gleichgewicht [mm], vor der Platzierung</translation>
        </message>
        <message>
            <source>Root mean square of the members' relative difference from their lengths on the source</source>
            <translation>Quadratisches Mittel der relativen Abweichung der Stäbe von ihren Längen auf der Quelle</translation>
        </message>
        <message>
            <source>Rounds that bring the members back to their lengths on the source; 0 for none</source>
            <translation>Runden, die die Stäbe auf ihre Längen auf der Quelle zurückbringen; 0 für keine</translation>
        </message>
        <message>
            <source>Shape of the solid members across, for their stress; it does not change the form</source>
            <translation>Form des vollen Stabquerschnitts, für die Spannung; die Form der Schale ändert er nicht</translation>
        </message>
        <message>
            <source>Show level ground at the lowest node, and the shadow on it</source>
            <translation>Ebenen Boden am tiefsten Knoten zeigen, und den Schatten darauf</translation>
        </message>
        <message>
            <source>Show level ground at the lowest support, and the shadow on it</source>
            <translation type="vanished">Ebenen Boden am tiefsten Auflager zeigen, und den Schatten darauf</translation>
        </message>
        <message>
            <source>Show the net as it was laid, pale, beside what it has become</source>
            <translation>Das Netz, wie es gelegt wurde, blass neben dem zeigen, was daraus wurde</translation>
        </message>
        <message>
            <source>Show the reactions as arrows, all to one scale</source>
            <translation>Die Auflagerkräfte als Pfeile zeigen, alle in einem Maßstab</translation>
        </message>
        <message>
            <source>Show what each colour stands for</source>
            <translation>Zeigen, wofür jede Farbe steht</translation>
        </message>
        <message>
            <source>Sides of the face that are one point</source>
            <translation>Seiten der Fläche, die ein Punkt sind</translation>
        </message>
        <message>
            <source>Snow load on plan; 0 for none</source>
            <translation>Schneelast auf den Grundriss; 0 für keine</translation>
        </message>
        <message>
            <source>Stress that the members bear, for their utilisation; 0 for unknown</source>
            <translation>Spannung, die die Stäbe ertragen, für ihre Ausnutzung; 0 für unbekannt</translation>
        </message>
        <message>
            <source>Sum of all loads, downwards</source>
            <translation>Summe aller Lasten, abwärts</translation>
        </message>
        <message>
            <source>Sum of all reactions, upwards</source>
            <translation>Summe aller Auflagerkräfte, aufwärts</translation>
        </message>
        <message>
            <source>Supports of their own, besides those of the recipe</source>
            <translation>Eigene Auflager, neben denen der Vorgabe</translation>
        </message>
        <message>
            <source>Take its nodes from the supports before it in the gridshell's list, instead of adding to them</source>
            <translation type="vanished">Seine Knoten den Auflagern nehmen, die in der Liste der Gitterschale vor ihm stehen, statt zu ihnen hinzuzukommen</translation>
        </message>
        <message>
            <source>The face or faces that the net lies on</source>
            <translation>Die Fläche oder Flächen, auf denen das Netz liegt</translation>
        </message>
        <message>
            <source>The gridshell whose panels these are</source>
            <translation>Die Gitterschale, deren Felder dies sind</translation>
        </message>
        <message>
            <source>The last cell along u joins the first</source>
            <translation>Die letzte Zelle entlang u schließt an die erste an</translation>
        </message>
        <message>
            <source>The last cell along v joins the first</source>
            <translation>Die letzte Zelle entlang v schließt an die erste an</translation>
        </message>
        <message>
            <source>The method that found the result</source>
            <translation>Das Verfahren, das zum Ergebnis führte</translation>
        </message>
        <message>
            <source>The net that is relaxed; several gridshells may share one</source>
            <translation>Das Netz, dessen Form gefunden wird; mehrere Gitterschalen können eines teilen</translation>
        </message>
        <message>
            <source>The net whose nodes are held</source>
            <translation type="vanished">Das Netz, dessen Knoten gehalten werden</translation>
        </message>
        <message>
            <source>The nodes around each panel: of each panel how many, then their numbers</source>
            <translation>Die Knoten um jedes Feld: für jedes Feld, wie viele Knoten, dann ihre Nummern</translation>
        </message>
        <message>
            <source>The nodes of each member: two numbers a member, counted from 0</source>
            <translation>Die Knoten jedes Stabes: zwei Nummern je Stab, ab 0 gezählt</translation>
        </message>
        <message>
            <source>The pattern that the nodes were laid in</source>
            <translation>Das Muster, in dem die Knoten gelegt wurden</translation>
        </message>
        <message>
            <source>The result in a sentence</source>
            <translation>Das Ergebnis in einem Satz</translation>
        </message>
        <message>
            <source>Time in the solver</source>
            <translation>Zeit im Löser</translation>
        </message>
        <message>
            <source>Turn the pattern: what ran along u runs along v</source>
            <translation>Das Muster drehen: was entlang u lief, läuft entlang v</translation>
        </message>
        <message>
            <source>Two nodes a member; empty for a lattice</source>
            <translation>Zwei Knoten je Stab; leer für ein Raster</translation>
        </message>
        <message>
            <source>Unit of the lengths in File</source>
            <translation>Einheit der Längen in File</translation>
        </message>
        <message>
            <source>Version of the set of properties of this object</source>
            <translation>Version der Eigenschaften dieses Objekts</translation>
        </message>
        <message>
            <source>Vertices of a mesh as near as this are one node; 0 for 1e-6 of its size</source>
            <translation>Punkte einer Netzdatei, die so nahe beieinander liegen, sind ein Knoten; 0 für 1e-6 ihrer Größe</translation>
        </message>
        <message>
            <source>Weight of the covering per area; 0 for none</source>
            <translation>Gewicht der Eindeckung je Fläche; 0 für keines</translation>
        </message>
        <message>
            <source>Weight of the members per length; 0 for none</source>
            <translation>Gewicht der Stäbe je Länge; 0 für keines</translation>
        </message>
        <message>
            <source>What came out otherwise</source>
            <translation>Was anders wurde als verlangt</translation>
        </message>
        <message>
            <source>What each of SourceElements is</source>
            <translation>Was jedes der SourceElements ist</translation>
        </message>
        <message>
            <source>What is drawn of the gridshell: members, its covering, or both</source>
            <translation>Was von der Gitterschale gezeichnet wird: Stäbe, Eindeckung oder beides</translation>
        </message>
        <message>
            <source>What is equal from cell to cell: the length on the face, or the surface's parameters</source>
            <translation>Was von Zelle zu Zelle gleich ist: die Länge auf der Fläche, oder die Parameter der Fläche</translation>
        </message>
        <message>
            <source>What the colour of each member stands for</source>
            <translation>Wofür die Farbe jedes Stabes steht</translation>
        </message>
        <message>
            <source>What the elements were when they were picked</source>
            <translation type="vanished">Was die Elemente waren, als sie gewählt wurden</translation>
        </message>
        <message>
            <source>What the face belonged to when it was picked</source>
            <translation>Wozu die Fläche gehörte, als sie gewählt wurde</translation>
        </message>
        <message>
            <source>What this object is to Funicular</source>
            <translation>Was dieses Objekt für Funicular ist</translation>
        </message>
        <message>
            <source>What was found</source>
            <translation type="vanished">Was gefunden wurde</translation>
        </message>
        <message>
            <source>What was kept of this gridshell under a name, see funicular.features.variants</source>
            <translation>Was von dieser Gitterschale unter einem Namen behalten wurde, siehe funicular.features.variants</translation>
        </message>
        <message>
            <source>Where a fixed range of this colouring begins (utilisation in %)</source>
            <translation>Wo ein fester Bereich dieser Färbung beginnt (Ausnutzung in %)</translation>
        </message>
        <message>
            <source>Where a fixed range of this colouring ends (utilisation in %)</source>
            <translation>Wo ein fester Bereich dieser Färbung endet (Ausnutzung in %)</translation>
        </message>
        <message>
            <source>Where the shell stands</source>
            <translation>Worauf die Schale steht</translation>
        </message>
        <message>
            <source>Where the sun stands, from north (y) clockwise: 180° is in the south</source>
            <translation>Wo die Sonne steht, von Norden (y) im Uhrzeigersinn: 180° ist Süden</translation>
        </message>
        <message>
            <source>Whether that was turned</source>
            <translation>Ob es gedreht war</translation>
        </message>
        <message>
            <source>Which node each was before edits; empty if the same</source>
            <translation>Welcher Knoten jeder vor Änderungen war; leer, wenn derselbe</translation>
        </message>
        <message>
            <source>Which nodes are held</source>
            <translation type="vanished">Welche Knoten gehalten werden</translation>
        </message>
        <message>
            <source>Young's modulus of the members, for their buckling between nodes; 0 for unknown</source>
            <translation>E-Modul der Stäbe, für ihr Knicken zwischen den Knoten; 0 für unbekannt</translation>
        </message>
    </context>
    <context>
        <name>Funicular</name>
        <message>
            <source>(The last good shape stays.)</source>
            <translation>(Die letzte gute Form bleibt.)</translation>
        </message>
        <message>
            <source>, each member with {} of EA and weight</source>
            <translation>, jeder Stab mit dem {}-Fachen von EA und Gewicht</translation>
        </message>
        <message>
            <source>, with EA and weight of members times {}</source>
            <translation type="vanished">, mit EA und Gewicht der Stäbe mal {}</translation>
        </message>
        <message>
            <source>, {} slack</source>
            <translation>, {} schlaff</translation>
        </message>
        <message>
            <source>. Select another face and press “Use selected faces”.</source>
            <translation>. Andere Fläche wählen und „Gewählte Flächen“ drücken.</translation>
        </message>
        <message>
            <source>Accuracy</source>
            <translation>Genauigkeit</translation>
        </message>
        <message>
            <source>Add load on picked nodes</source>
            <translation>Last auf gewählte Knoten</translation>
        </message>
        <message>
            <source>Allow tension</source>
            <translation>Zug zulassen</translation>
        </message>
        <message>
            <source>Along isolines</source>
            <translation>Auf Isolinien</translation>
        </message>
        <message>
            <source>Alternating</source>
            <translation>Wechselnd</translation>
        </message>
        <message>
            <source>Alternatives</source>
            <translation>Alternativen</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Winkel</translation>
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it is an undo step.</source>
            <translation>Ein anderer Befehl hat das Panel von {} beendet. Was darin eingegeben wurde, ist ein Schritt, der rückgängig zu machen ist.</translation>
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it was taken back.</source>
            <translation>Ein anderer Befehl hat das Panel von {} beendet. Was darin eingegeben wurde, ist zurückgenommen.</translation>
        </message>
        <message>
            <source>Another dialog is open in the task panel. Close it, then edit the gridshell.</source>
            <translation>Im Aufgabenfenster ist ein anderer Dialog offen. Ihn schließen, dann die Gitterschale bearbeiten.</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <source>Axonometric</source>
            <translation>Axonometrie</translation>
        </message>
        <message>
            <source>Back to {}</source>
            <translation>Zurück zu {}</translation>
        </message>
        <message>
            <source>Bar height</source>
            <translation>Stabhöhe</translation>
        </message>
        <message>
            <source>Bar width</source>
            <translation>Stabbreite</translation>
        </message>
        <message>
            <source>Bars are as large as the section below.</source>
            <translation>Die Stäbe sind so groß wie der Querschnitt unten.</translation>
        </message>
        <message>
            <source>Begin again from the net as it lies on its source</source>
            <translation>Neu beginnen, vom Netz, wie es auf seiner Quelle liegt</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Rand</translation>
        </message>
        <message>
            <source>Brick</source>
            <translation>Mauerverband</translation>
        </message>
        <message>
            <source>But its panels have shrunk to {} % of their area, as where one point holds all: choose other supports</source>
            <translation>Aber die Felder sind auf {} % ihrer Fläche geschrumpft, wie wenn ein Punkt alles hält: andere Auflager wählen</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Cancelled; what was measured stays.</source>
            <translation>Abgebrochen; was gemessen wurde, bleibt.</translation>
        </message>
        <message>
            <source>Cells along u</source>
            <translation>Zellen in u</translation>
        </message>
        <message>
            <source>Cells along v</source>
            <translation>Zellen in v</translation>
        </message>
        <message>
            <source>Centred</source>
            <translation>Zentriert</translation>
        </message>
        <message>
            <source>Choose one alternative, then restore it.</source>
            <translation>Eine Alternative wählen, dann wiederherstellen.</translation>
        </message>
        <message>
            <source>Choose one to see it, two (with Ctrl) to compare them; F2 renames. Without a choice the present form is shown.</source>
            <translation>Eine wählen, um sie zu sehen, zwei (mit Strg), um sie zu vergleichen; F2 benennt um. Ohne Wahl wird die jetzige Form gezeigt.</translation>
        </message>
        <message>
            <source>Chosen in the list: {}. Hold it in another way, soften or lift it.</source>
            <translation>In der Liste gewählt: {}. Anders halten, weicher machen oder lösen.</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Leeren</translation>
        </message>
        <message>
            <source>Click a point: the gridshell takes its accuracy and method.</source>
            <translation>Einen Punkt anklicken: die Gitterschale übernimmt seine Genauigkeit und sein Verfahren.</translation>
        </message>
        <message>
            <source>Close the panel that is open, then click the point again.</source>
            <translation>Das offene Panel schließen, dann den Punkt erneut anklicken.</translation>
        </message>
        <message>
            <source>Colour by</source>
            <translation>Farbe nach</translation>
        </message>
        <message>
            <source>Colours and readings</source>
            <translation>Farben und Ablesen</translation>
        </message>
        <message>
            <source>Compression only</source>
            <translation>Nur Druck</translation>
        </message>
        <message>
            <source>Compression only, at most {}</source>
            <translation>Nur Druck, höchstens {}</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>Ecken</translation>
        </message>
        <message>
            <source>Corners and border planes</source>
            <translation>Ecken und Randebenen</translation>
        </message>
        <message>
            <source>Covering</source>
            <translation>Eindeckung</translation>
        </message>
        <message>
            <source>Crossed</source>
            <translation>Gekreuzt</translation>
        </message>
        <message>
            <source>Crossing</source>
            <translation>Kreuzungswinkel</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Tiefe</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <source>Diagonal</source>
            <translation>Diagonal</translation>
        </message>
        <message>
            <source>Diagrid</source>
            <translation>Diagrid</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Richtung</translation>
        </message>
        <message>
            <source>Displacement × {}</source>
            <translation>Verschiebung × {}</translation>
        </message>
        <message>
            <source>Display</source>
            <translation>Darstellung</translation>
        </message>
        <message>
            <source>Divide curves</source>
            <translation>Kurven teilen</translation>
        </message>
        <message>
            <source>Do again what was taken back</source>
            <translation>Zurückgenommenes wieder tun</translation>
        </message>
        <message>
            <source>Do without, or end it while it goes on</source>
            <translation>Darauf verzichten, oder es beenden, solange es läuft</translation>
        </message>
        <message>
            <source>Edges and vertices</source>
            <translation type="vanished">Kanten und Eckpunkte</translation>
        </message>
        <message>
            <source>Edit gridshell</source>
            <translation>Gitterschale bearbeiten</translation>
        </message>
        <message>
            <source>Equal</source>
            <translation>Gleich</translation>
        </message>
        <message>
            <source>Equal in</source>
            <translation>Gleich in</translation>
        </message>
        <message>
            <source>Equal lengths</source>
            <translation>Gleiche Längen</translation>
        </message>
        <message>
            <source>Esc takes nothing back: press Cancel for that, or OK to keep it.</source>
            <translation>Esc nimmt nichts zurück: dafür Abbrechen drücken, oder OK, um es zu behalten.</translation>
        </message>
        <message>
            <source>Every node of the border stands</source>
            <translation>Jeder Knoten des Randes steht auf</translation>
        </message>
        <message>
            <source>Exaggeration</source>
            <translation>Überhöhung</translation>
        </message>
        <message>
            <source>Faces</source>
            <translation>Flächen</translation>
        </message>
        <message>
            <source>Faces of {} bodies are selected: select one or more of a single body in the 3D view, then press again.</source>
            <translation>Flächen von {} Körpern sind gewählt: eine oder mehrere eines einzigen Körpers in der 3D-Ansicht wählen, dann erneut drücken.</translation>
        </message>
        <message>
            <source>Finding the shape to measure against</source>
            <translation>Suche die Form, an der gemessen wird</translation>
        </message>
        <message>
            <source>Fixed</source>
            <translation>Fest</translation>
        </message>
        <message>
            <source>Fixed range</source>
            <translation>Fester Bereich</translation>
        </message>
        <message>
            <source>Flat sheet</source>
            <translation>Ebenes Netz</translation>
        </message>
        <message>
            <source>Follows the expression {}</source>
            <translation>Folgt dem Ausdruck {}</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Kraft</translation>
        </message>
        <message>
            <source>Force +</source>
            <translation>Kraft +</translation>
        </message>
        <message>
            <source>Force {}</source>
            <translation>Kraft {}</translation>
        </message>
        <message>
            <source>Force −</source>
            <translation>Kraft −</translation>
        </message>
        <message>
            <source>Forget the chosen alternative</source>
            <translation>Die gewählte Alternative vergessen</translation>
        </message>
        <message>
            <source>Free</source>
            <translation>Frei</translation>
        </message>
        <message>
            <source>From the source</source>
            <translation>Von der Quelle</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>Vorne</translation>
        </message>
        <message>
            <source>Full lines: how far the nodes truly are from where they stand in equilibrium. Dashed lines: how far the solver says they are. Farther right is more accurate, lower is faster.</source>
            <translation>Volle Linien: wie weit die Knoten wirklich vom Gleichgewicht entfernt sind. Gestrichelt: wie weit sie es laut Löser sind. Weiter rechts ist genauer, tiefer ist schneller.</translation>
        </message>
        <message>
            <source>Funicular</source>
            <translation>Funicular</translation>
        </message>
        <message>
            <source>Funicular guide</source>
            <translation>Anleitung zu Funicular</translation>
        </message>
        <message>
            <source>Go on from the inputs of the chosen alternative</source>
            <translation>Mit den Eingaben der gewählten Alternative weitermachen</translation>
        </message>
        <message>
            <source>Gridshell</source>
            <translation>Gitterschale</translation>
        </message>
        <message>
            <source>Ground, shadow</source>
            <translation>Boden, Schatten</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Höhe</translation>
        </message>
        <message>
            <source>Height {}</source>
            <translation>Höhe {}</translation>
        </message>
        <message>
            <source>Hexagon</source>
            <translation>Sechseck</translation>
        </message>
        <message>
            <source>Hold it in its place</source>
            <translation type="vanished">Hält sie an ihrem Ort</translation>
        </message>
        <message>
            <source>Hold it nowhere, whatever the recipe or other supports say</source>
            <translation>Hält sie nirgends, was auch Vorgabe oder andere Auflager sagen</translation>
        </message>
        <message>
            <source>Hold it where it was laid, on the source; the green arrow raises it</source>
            <translation>Dort halten, wo er gelegt wurde, auf der Quelle; der grüne Pfeil hebt ihn</translation>
        </message>
        <message>
            <source>How far the farthest node is from where it was laid</source>
            <translation>Wie weit der entfernteste Knoten von dort ist, wo er gelegt wurde</translation>
        </message>
        <message>
            <source>How far the nodes are from where they were laid, on the average</source>
            <translation>Wie weit die Knoten im Mittel von dort sind, wo sie gelegt wurden</translation>
        </message>
        <message>
            <source>How stiff the chosen supports are: at the right end rigid, at the left end free</source>
            <translation>Wie steif die gewählten Auflager sind: ganz rechts starr, ganz links frei</translation>
        </message>
        <message>
            <source>How the solve went, against time. Full line: distance from equilibrium, dashed: largest unbalanced force. The level line is what is asked for: below it a curve has arrived.</source>
            <translation>Verlauf der Lösung über der Zeit. Volle Linie: Abstand vom Gleichgewicht, gestrichelt: größte unausgeglichene Kraft. Die waagrechte Linie ist, was verlangt ist: darunter ist eine Kurve am Ziel.</translation>
        </message>
        <message>
            <source>It stands on its corners</source>
            <translation>Sie steht auf ihren Ecken</translation>
        </message>
        <message>
            <source>It stands on its corners, and its borders stay in vertical planes</source>
            <translation>Sie steht auf ihren Ecken, und ihre Ränder bleiben in lotrechten Ebenen</translation>
        </message>
        <message>
            <source>It stands on its own supports alone</source>
            <translation>Sie steht auf ihren eigenen Auflagern allein</translation>
        </message>
        <message>
            <source>Its unit</source>
            <translation>Ihre Einheit</translation>
        </message>
        <message>
            <source>Kagome</source>
            <translation>Kagome</translation>
        </message>
        <message>
            <source>Keep this</source>
            <translation>Behalten</translation>
        </message>
        <message>
            <source>Keep this form under a name</source>
            <translation>Diese Form unter einem Namen behalten</translation>
        </message>
        <message>
            <source>Laid</source>
            <translation>Gelegt</translation>
        </message>
        <message>
            <source>Largest compression in a member</source>
            <translation>Größter Druck in einem Stab</translation>
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation>Größter Zug in einem Stab</translation>
        </message>
        <message>
            <source>Lay the net on the faces that are selected in the 3D view</source>
            <translation>Das Netz auf die Flächen legen, die in der 3D-Ansicht gewählt sind</translation>
        </message>
        <message>
            <source>Lay the pattern</source>
            <translation>Muster darüber</translation>
        </message>
        <message>
            <source>Leave them out</source>
            <translation>Weglassen</translation>
        </message>
        <message>
            <source>Legend</source>
            <translation>Legende</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Länge</translation>
        </message>
        <message>
            <source>Length matching</source>
            <translation>Längenabgleich</translation>
        </message>
        <message>
            <source>Length matching was left out: each of its rounds is one more solve.</source>
            <translation>Der Längenabgleich blieb außen vor: jede seiner Runden ist ein Lösen mehr.</translation>
        </message>
        <message>
            <source>Length of the longest member</source>
            <translation>Länge des längsten Stabes</translation>
        </message>
        <message>
            <source>Length {}</source>
            <translation>Länge {}</translation>
        </message>
        <message>
            <source>Lengths differ by {} % → {} % (rms), best reached after {} rounds</source>
            <translation>Längen weichen um {} % → {} % ab (quadr. Mittel), am besten nach {} Runden</translation>
        </message>
        <message>
            <source>Lengths differ from those on the source by {} % (rms)</source>
            <translation>Längen weichen von denen auf der Quelle um {} % ab (quadr. Mittel)</translation>
        </message>
        <message>
            <source>Less than {} from equilibrium</source>
            <translation>Weniger als {} vom Gleichgewicht</translation>
        </message>
        <message>
            <source>Let go of what is chosen in the list, or free the nodes that are picked</source>
            <translation>Loslassen, was in der Liste gewählt ist, oder die markierten Knoten frei machen</translation>
        </message>
        <message>
            <source>Let it slide in the plane across the direction that is chosen below</source>
            <translation>Lässt sie in der Ebene gleiten, die quer zur unten gewählten Richtung liegt</translation>
        </message>
        <message>
            <source>Let it slide in the vertical plane of its edge or of the border</source>
            <translation>Lässt sie in der lotrechten Ebene ihrer Kante oder des Randes gleiten</translation>
        </message>
        <message>
            <source>Let it slide on a line in the direction that is chosen below</source>
            <translation>Lässt sie auf einer Linie in der unten gewählten Richtung gleiten</translation>
        </message>
        <message>
            <source>Let it slide up and down</source>
            <translation>Lässt sie auf und ab gleiten</translation>
        </message>
        <message>
            <source>Lift</source>
            <translation>Lösen</translation>
        </message>
        <message>
            <source>Line along</source>
            <translation>Linie entlang</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linien</translation>
        </message>
        <message>
            <source>Lines and covering</source>
            <translation>Linien und Eindeckung</translation>
        </message>
        <message>
            <source>Load {}</source>
            <translation>Last {}</translation>
        </message>
        <message>
            <source>Longest</source>
            <translation>Längster</translation>
        </message>
        <message>
            <source>Lowest points</source>
            <translation>Tiefste Punkte</translation>
        </message>
        <message>
            <source>Match lengths</source>
            <translation>Längen abgleichen</translation>
        </message>
        <message>
            <source>Matching lengths, {} rounds</source>
            <translation>Gleiche Längen ab, {} Runden</translation>
        </message>
        <message>
            <source>Matplotlib draws with another Qt than FreeCAD's, as some addon has asked of it: start FreeCAD again, and use Funicular before that addon.</source>
            <translation>Matplotlib zeichnet mit einem anderen Qt als dem von FreeCAD, weil ein Addon das verlangt hat: FreeCAD neu starten und Funicular vor diesem Addon verwenden.</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>Erneut messen</translation>
        </message>
        <message>
            <source>Measure the gridshell as it is now</source>
            <translation>Die Gitterschale messen, wie sie jetzt ist</translation>
        </message>
        <message>
            <source>Measuring</source>
            <translation>Messe</translation>
        </message>
        <message>
            <source>Measuring {} by {}, {} of {}</source>
            <translation>Messe {} mit {}, {} von {}</translation>
        </message>
        <message>
            <source>Member force</source>
            <translation>Stabkraft</translation>
        </message>
        <message>
            <source>Member length</source>
            <translation>Stablänge</translation>
        </message>
        <message>
            <source>Member {}</source>
            <translation>Stab {}</translation>
        </message>
        <message>
            <source>Members</source>
            <translation>Stäbe</translation>
        </message>
        <message>
            <source>Members up to {} times as long as on the face: stiffer ones stretch less</source>
            <translation>Stäbe bis zu {}-mal so lang wie auf der Fläche: steifere dehnen sich weniger</translation>
        </message>
        <message>
            <source>Mesh file</source>
            <translation>Netzdatei</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Verfahren</translation>
        </message>
        <message>
            <source>More of the net</source>
            <translation>Mehr zum Netz</translation>
        </message>
        <message>
            <source>Most shear</source>
            <translation>Größte Scherung</translation>
        </message>
        <message>
            <source>Needs a section and the strength or Young's modulus of its material.</source>
            <translation>Braucht einen Querschnitt und die Festigkeit oder den E-Modul des Werkstoffs.</translation>
        </message>
        <message>
            <source>Needs a section: choose its shape and size.</source>
            <translation>Braucht einen Querschnitt: seine Form und Größe wählen.</translation>
        </message>
        <message>
            <source>Net</source>
            <translation>Netz</translation>
        </message>
        <message>
            <source>Newton</source>
            <translation>Newton</translation>
        </message>
        <message>
            <source>No place for the load is selected: select nodes of the gridshell, or edges and vertices of its source, in the 3D view.</source>
            <translation>Für die Last ist kein Ort ausgewählt: Knoten der Gitterschale oder Kanten und Punkte ihrer Quelle in der 3D-Ansicht auswählen.</translation>
        </message>
        <message>
            <source>No tool (Esc): a click on a mark chooses its support in the list</source>
            <translation>Kein Werkzeug (Esc): ein Klick auf ein Zeichen wählt sein Auflager in der Liste</translation>
        </message>
        <message>
            <source>Node {}</source>
            <translation>Knoten {}</translation>
        </message>
        <message>
            <source>Nodes</source>
            <translation>Knoten</translation>
        </message>
        <message>
            <source>Nodes picked: {}</source>
            <translation>Knoten markiert: {}</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <source>Nothing to build on is selected. Select a face in the 3D view, or several of one body, then run Gridshell again.</source>
            <translation>Es ist nichts gewählt, worauf zu bauen wäre. Eine Fläche in der 3D-Ansicht wählen, oder mehrere eines Körpers, dann Gitterschale erneut ausführen.</translation>
        </message>
        <message>
            <source>Off, mean</source>
            <translation>Fern, Mittel</translation>
        </message>
        <message>
            <source>Off, most</source>
            <translation>Fern, größte</translation>
        </message>
        <message>
            <source>On a line</source>
            <translation type="vanished">Auf einer Linie</translation>
        </message>
        <message>
            <source>On a plane</source>
            <translation type="vanished">Auf einer Ebene</translation>
        </message>
        <message>
            <source>On its vertical line</source>
            <translation type="vanished">Auf ihrer lotrechten Linie</translation>
        </message>
        <message>
            <source>On its vertical plane</source>
            <translation type="vanished">Auf ihrer lotrechten Ebene</translation>
        </message>
        <message>
            <source>One iteration of the solver more, then a pause</source>
            <translation>Eine Iteration des Lösers mehr, dann Pause</translation>
        </message>
        <message>
            <source>Opening rims</source>
            <translation>Öffnungsränder</translation>
        </message>
        <message>
            <source>Other diagonal</source>
            <translation>Andere Diagonale</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Parameter</translation>
        </message>
        <message>
            <source>Parts of {} gridshells are selected: select nodes or members of one in the 3D view.</source>
            <translation>Teile von {} Gitterschalen sind gewählt: Knoten oder Stäbe von einer in der 3D-Ansicht wählen.</translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation>Muster</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Pause</translation>
        </message>
        <message>
            <source>Paused</source>
            <translation>Angehalten</translation>
        </message>
        <message>
            <source>Pick all nodes on an edge of the source: click near it</source>
            <translation>Alle Knoten auf einer Kante der Quelle markieren: in ihre Nähe klicken</translation>
        </message>
        <message>
            <source>Pick nodes in the 3D view with one of the tools, or choose a support.</source>
            <translation>Knoten in der 3D-Ansicht mit einem der Werkzeuge markieren, oder ein Auflager wählen.</translation>
        </message>
        <message>
            <source>Pick nodes: click one, or drag a box; with Alt a lasso. Shift adds to what is picked</source>
            <translation>Knoten markieren: einen anklicken oder ein Rechteck ziehen; mit Alt ein Lasso. Umschalt fügt hinzu</translation>
        </message>
        <message>
            <source>Pick nothing</source>
            <translation>Nichts markieren</translation>
        </message>
        <message>
            <source>Pick the nodes in a box. Shift adds to what is picked</source>
            <translation>Die Knoten in einem Rechteck markieren. Umschalt fügt hinzu</translation>
        </message>
        <message>
            <source>Pick the nodes within a line drawn by hand. Shift adds to what is picked</source>
            <translation>Die Knoten innerhalb einer Freihandlinie markieren. Umschalt fügt hinzu</translation>
        </message>
        <message>
            <source>Picked: {}, {} nodes</source>
            <translation>Markiert: {}, {} Knoten</translation>
        </message>
        <message>
            <source>Plan</source>
            <translation>Grundriss</translation>
        </message>
        <message>
            <source>Plane across</source>
            <translation>Ebene quer zu</translation>
        </message>
        <message>
            <source>Point load</source>
            <translation>Einzellast</translation>
        </message>
        <message>
            <source>Point loads</source>
            <translation>Einzellasten</translation>
        </message>
        <message>
            <source>Points</source>
            <translation type="vanished">Punkte</translation>
        </message>
        <message>
            <source>Properties to change: {}.</source>
            <translation>Zu ändernde Eigenschaften: {}.</translation>
        </message>
        <message>
            <source>Pure</source>
            <translation>Rein</translation>
        </message>
        <message>
            <source>Put 1 kN on each of the nodes that are picked, or on those of the edges and vertices of the source that are selected in FreeCAD</source>
            <translation>1 kN auf jeden gewählten Knoten setzen, oder auf die Knoten der in FreeCAD ausgewählten Kanten und Punkte der Quelle</translation>
        </message>
        <message>
            <source>Quad</source>
            <translation>Viereck</translation>
        </message>
        <message>
            <source>Raise</source>
            <translation>Heben</translation>
        </message>
        <message>
            <source>Raise or lower a node: drag it along z, and the net is laid anew</source>
            <translation>Einen Knoten heben oder senken: ihn entlang z ziehen, und das Netz wird neu gelegt</translation>
        </message>
        <message>
            <source>Reaction {}</source>
            <translation>Auflagerkraft {}</translation>
        </message>
        <message>
            <source>Reactions</source>
            <translation>Auflagerkräfte</translation>
        </message>
        <message>
            <source>Recipe {}: {} nodes</source>
            <translation>Vorgabe {}: {} Knoten</translation>
        </message>
        <message>
            <source>Recipe: {}</source>
            <translation>Vorgabe: {}</translation>
        </message>
        <message>
            <source>Rectangular</source>
            <translation>Rechteckig</translation>
        </message>
        <message>
            <source>Rectangular bars</source>
            <translation>Rechteckige Stäbe</translation>
        </message>
        <message>
            <source>Rectangular bars and covering</source>
            <translation>Rechteckige Stäbe und Eindeckung</translation>
        </message>
        <message>
            <source>Redo</source>
            <translation>Wiederholen</translation>
        </message>
        <message>
            <source>Relax slowly</source>
            <translation>Langsam zusehen</translation>
        </message>
        <message>
            <source>Relaxation</source>
            <translation>Relaxation</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Reset</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <source>Restore</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Weiter</translation>
        </message>
        <message>
            <source>Ribs u</source>
            <translation>Rippen u</translation>
        </message>
        <message>
            <source>Ribs v</source>
            <translation>Rippen v</translation>
        </message>
        <message>
            <source>Rigid</source>
            <translation>Starr</translation>
        </message>
        <message>
            <source>Rise</source>
            <translation>Stich</translation>
        </message>
        <message>
            <source>Round</source>
            <translation>Rund</translation>
        </message>
        <message>
            <source>Round bars</source>
            <translation>Runde Stäbe</translation>
        </message>
        <message>
            <source>Round bars and covering</source>
            <translation>Runde Stäbe und Eindeckung</translation>
        </message>
        <message>
            <source>Ruled faces</source>
            <translation>Regelflächen</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>Speichern unter …</translation>
        </message>
        <message>
            <source>Save what was measured</source>
            <translation>Messung speichern</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Querschnitt</translation>
        </message>
        <message>
            <source>Select a gridshell and press “What accuracy costs”.</source>
            <translation>Eine Gitterschale wählen und „Was Genauigkeit kostet“ drücken.</translation>
        </message>
        <message>
            <source>Select either nodes of the gridshell or edges of its source, and make one support of each.</source>
            <translation>Entweder Knoten der Gitterschale oder Kanten ihrer Quelle wählen und aus jedem ein Auflager machen.</translation>
        </message>
        <message>
            <source>Shared by</source>
            <translation>Verteilt nach</translation>
        </message>
        <message>
            <source>Shift along u</source>
            <translation>Versatz in u</translation>
        </message>
        <message>
            <source>Shift along v</source>
            <translation>Versatz in v</translation>
        </message>
        <message>
            <source>Shorten what has become longer than on the source and lengthen what has become shorter, round by round, as far as equilibrium lets it</source>
            <translation>Kürzen, was länger wurde als auf der Quelle, und längen, was kürzer wurde, Runde um Runde, so weit das Gleichgewicht es zulässt</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Zeigen</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Seite</translation>
        </message>
        <message>
            <source>Slack</source>
            <translation>Schlaff</translation>
        </message>
        <message>
            <source>Slack members</source>
            <translation>Schlaffe Stäbe</translation>
        </message>
        <message>
            <source>Slack members were left out of the net.</source>
            <translation>Schlaffe Stäbe wurden aus dem Netz weggelassen.</translation>
        </message>
        <message>
            <source>Snow</source>
            <translation>Schnee</translation>
        </message>
        <message>
            <source>Solution</source>
            <translation>Lösung</translation>
        </message>
        <message>
            <source>Solve once more without each effect: how much time it takes, and how far the shape moves. Nothing is left out by this.</source>
            <translation>Einmal mehr ohne jede Einwirkung lösen: wie viel Zeit sie braucht und wie weit sich die Form bewegt. Weggelassen wird dadurch nichts.</translation>
        </message>
        <message>
            <source>Solving</source>
            <translation>Löse</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <source>Source, pale</source>
            <translation>Quelle, blass</translation>
        </message>
        <message>
            <source>Start (u, v)</source>
            <translation>Anfang (u, v)</translation>
        </message>
        <message>
            <source>Step along u</source>
            <translation>Schritt in u</translation>
        </message>
        <message>
            <source>Step along v</source>
            <translation>Schritt in v</translation>
        </message>
        <message>
            <source>Stiffness</source>
            <translation>Steifigkeit</translation>
        </message>
        <message>
            <source>Stiffness EA</source>
            <translation>Steifigkeit EA</translation>
        </message>
        <message>
            <source>Stop measuring; what was measured stays</source>
            <translation>Aufhören zu messen; was gemessen wurde, bleibt</translation>
        </message>
        <message>
            <source>Strength</source>
            <translation>Festigkeit</translation>
        </message>
        <message>
            <source>Stress</source>
            <translation>Spannung</translation>
        </message>
        <message>
            <source>Stress {}</source>
            <translation>Spannung {}</translation>
        </message>
        <message>
            <source>Sun altitude</source>
            <translation>Sonnenhöhe</translation>
        </message>
        <message>
            <source>Sun azimuth</source>
            <translation>Sonne, Azimut</translation>
        </message>
        <message>
            <source>Support</source>
            <translation>Auflager</translation>
        </message>
        <message>
            <source>Supports</source>
            <translation>Auflager</translation>
        </message>
        <message>
            <source>Table, and a picture of the same name (*.csv)</source>
            <translation>Tabelle und ein Bild gleichen Namens (*.csv)</translation>
        </message>
        <message>
            <source>Take back the last step in this section</source>
            <translation>Den letzten Schritt in diesem Abschnitt zurücknehmen</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Herausnehmen</translation>
        </message>
        <message>
            <source>Take them back</source>
            <translation>Zurücknehmen</translation>
        </message>
        <message>
            <source>Take {} away</source>
            <translation>{} wegnehmen</translation>
        </message>
        <message>
            <source>Ten times as stiff</source>
            <translation>Zehnmal so steif</translation>
        </message>
        <message>
            <source>That is less than {}: it may be left out.</source>
            <translation>Das ist weniger als {}: es darf entfallen.</translation>
        </message>
        <message>
            <source>The direction of a line, or the normal of a plane: an axis, or a straight edge or plane face that is selected</source>
            <translation>Die Richtung einer Linie oder die Normale einer Ebene: eine Achse, oder eine gerade Kante oder ebene Fläche, die gewählt ist</translation>
        </message>
        <message>
            <source>The gridshell has changed since this was begun: press “Measure again”.</source>
            <translation>Die Gitterschale hat sich seit Beginn geändert: „Erneut messen“ drücken.</translation>
        </message>
        <message>
            <source>The gridshell has no Net any more.</source>
            <translation>Die Gitterschale hat kein Netz mehr.</translation>
        </message>
        <message>
            <source>The guide is missing: {}. Install the addon again.</source>
            <translation>Die Anleitung fehlt: {}. Das Addon neu installieren.</translation>
        </message>
        <message>
            <source>The longest arrow is {}, at node {}.</source>
            <translation>Der längste Pfeil ist {}, an Knoten {}.</translation>
        </message>
        <message>
            <source>The lowest nodes stand</source>
            <translation>Die tiefsten Knoten stehen auf</translation>
        </message>
        <message>
            <source>The members cannot carry these loads.</source>
            <translation>Die Stäbe können diese Lasten nicht tragen.</translation>
        </message>
        <message>
            <source>The rims of openings stand</source>
            <translation>Die Ränder der Öffnungen stehen auf</translation>
        </message>
        <message>
            <source>The way from the source is drawn {} times as long. Figures are the true ones.</source>
            <translation>Der Weg von der Quelle ist {}-mal so lang gezeichnet. Die Zahlen sind die wahren.</translation>
        </message>
        <message>
            <source>There are no reactions yet.</source>
            <translation>Noch gibt es keine Auflagerkräfte.</translation>
        </message>
        <message>
            <source>These steps make about {} nodes: press Enter to lay them, or give longer ones</source>
            <translation>Diese Schritte ergeben etwa {} Knoten: Eingabetaste drücken, um sie zu legen, oder längere angeben</translation>
        </message>
        <message>
            <source>Together these may move it by {}: leave out one, then measure again.</source>
            <translation>Zusammen bewegen diese sie vielleicht um {}: eine weglassen, dann erneut messen.</translation>
        </message>
        <message>
            <source>Triangle</source>
            <translation>Dreieck</translation>
        </message>
        <message>
            <source>Triangles</source>
            <translation>Dreiecke</translation>
        </message>
        <message>
            <source>Turn the view, and let it hold the whole net: {}</source>
            <translation>Die Ansicht drehen, sodass das ganze Netz darin ist: {}</translation>
        </message>
        <message>
            <source>Turned</source>
            <translation>Gedreht</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>Rückgängig</translation>
        </message>
        <message>
            <source>Undo and redo end the panel of {}: its inputs no longer hold.</source>
            <translation>Rückgängig und Wiederholen beenden das Panel von {}: seine Eingaben gelten nicht mehr.</translation>
        </message>
        <message>
            <source>Undo matching</source>
            <translation>Ohne Abgleich</translation>
        </message>
        <message>
            <source>Upright line</source>
            <translation>Lotrechte Linie</translation>
        </message>
        <message>
            <source>Upright plane</source>
            <translation>Lotrechte Ebene</translation>
        </message>
        <message>
            <source>Use selected faces</source>
            <translation>Gewählte Flächen</translation>
        </message>
        <message>
            <source>Utilisation</source>
            <translation>Ausnutzung</translation>
        </message>
        <message>
            <source>Utilisation {}</source>
            <translation>Ausnutzung {}</translation>
        </message>
        <message>
            <source>Variant {}</source>
            <translation>Variante {}</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>Voronoi</source>
            <translation>Voronoi</translation>
        </message>
        <message>
            <source>Wait until the form has settled, then keep it.</source>
            <translation>Warten, bis die Form zur Ruhe gekommen ist, dann behalten.</translation>
        </message>
        <message>
            <source>Watch how the net comes to hang by the relaxation of Brivio et al. (2009), step by step, instead of the fast solver. What it comes to is the same.</source>
            <translation>Zusehen, wie das Netz durch die Relaxation von Brivio et al. (2009) Schritt für Schritt ins Hängen kommt, statt des schnellen Lösers. Das Ergebnis ist dasselbe.</translation>
        </message>
        <message>
            <source>Weight</source>
            <translation>Gewicht</translation>
        </message>
        <message>
            <source>Weights</source>
            <translation>Gewichte</translation>
        </message>
        <message>
            <source>Weld within</source>
            <translation>Verschmelzen bis</translation>
        </message>
        <message>
            <source>What a solve to this accuracy takes, as predicted. Below it the largest step that brings the net as near to the smooth surface that it stands for, which is no error where members are the straight beams that will be built.</source>
            <translation>Was das Lösen mit dieser Genauigkeit voraussichtlich kostet. Darunter der größte Schritt, mit dem das Netz der glatten Fläche, für die es steht, ebenso nahe kommt; wo Stäbe die geraden Balken sind, die gebaut werden, ist das kein Fehler.</translation>
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation>Was Genauigkeit kostet</translation>
        </message>
        <message>
            <source>What accuracy costs: {}</source>
            <translation>Was Genauigkeit kostet: {}</translation>
        </message>
        <message>
            <source>What effects cost</source>
            <translation>Was Einwirkungen kosten</translation>
        </message>
        <message>
            <source>What is chosen here is ringed in the 3D view, and changed below</source>
            <translation>Was hier gewählt ist, ist in der 3D-Ansicht umringt und wird unten geändert</translation>
        </message>
        <message>
            <source>What is selected is curved and has no one direction: select a straight edge or a plane face.</source>
            <translation>Das Gewählte ist gekrümmt und hat keine eine Richtung: eine gerade Kante oder ebene Fläche wählen.</translation>
        </message>
        <message>
            <source>Where the force points to</source>
            <translation>Wohin die Kraft zeigt</translation>
        </message>
        <message>
            <source>Whether it stands in compression only</source>
            <translation>Ob sie nur unter Druck steht</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Breite</translation>
        </message>
        <message>
            <source>Within {} of the smooth form: step {}, {}</source>
            <translation>Auf {} an der glatten Form: Schritt {}, {}</translation>
        </message>
        <message>
            <source>Without it {}, and the shape moves by {}.</source>
            <translation>Ohne sie {}, und die Form bewegt sich um {}.</translation>
        </message>
        <message>
            <source>Write what was measured as a table (.csv) and a picture (.png)</source>
            <translation>Was gemessen wurde, als Tabelle (.csv) und Bild (.png) schreiben</translation>
        </message>
        <message>
            <source>Young's modulus</source>
            <translation>E-Modul</translation>
        </message>
        <message>
            <source>Zigzag</source>
            <translation>Zickzack</translation>
        </message>
        <message>
            <source>a recipe for all nodes that no support speaks of</source>
            <translation>eine Vorgabe für alle Knoten, von denen kein Auflager spricht</translation>
        </message>
        <message>
            <source>about {}</source>
            <translation>etwa {}</translation>
        </message>
        <message>
            <source>accuracy now: {}</source>
            <translation>Genauigkeit jetzt: {}</translation>
        </message>
        <message>
            <source>against x</source>
            <translation>gegen x</translation>
        </message>
        <message>
            <source>against y</source>
            <translation>gegen y</translation>
        </message>
        <message>
            <source>along x</source>
            <translation>in x</translation>
        </message>
        <message>
            <source>along y</source>
            <translation>in y</translation>
        </message>
        <message>
            <source>asked for: {}</source>
            <translation>verlangt: {}</translation>
        </message>
        <message>
            <source>borne</source>
            <translation>trägt</translation>
        </message>
        <message>
            <source>borne (own scale)</source>
            <translation>trägt (eigener Maßstab)</translation>
        </message>
        <message>
            <source>by buckling</source>
            <translation>durch Knicken</translation>
        </message>
        <message>
            <source>by step</source>
            <translation>nach Schritt</translation>
        </message>
        <message>
            <source>cancelled</source>
            <translation>abgebrochen</translation>
        </message>
        <message>
            <source>carries</source>
            <translation>trägt</translation>
        </message>
        <message>
            <source>change</source>
            <translation>Änderung</translation>
        </message>
        <message>
            <source>compression</source>
            <translation>Druck</translation>
        </message>
        <message>
            <source>compression −</source>
            <translation>Druck −</translation>
        </message>
        <message>
            <source>compression − (own scale)</source>
            <translation>Druck − (eigener Maßstab)</translation>
        </message>
        <message>
            <source>distance from equilibrium</source>
            <translation>Abstand vom Gleichgewicht</translation>
        </message>
        <message>
            <source>down</source>
            <translation>abwärts</translation>
        </message>
        <message>
            <source>fixed</source>
            <translation>fest</translation>
        </message>
        <message>
            <source>free</source>
            <translation>frei</translation>
        </message>
        <message>
            <source>from</source>
            <translation>von</translation>
        </message>
        <message>
            <source>no</source>
            <translation>nein</translation>
        </message>
        <message>
            <source>off</source>
            <translation>aus</translation>
        </message>
        <message>
            <source>on a line</source>
            <translation>auf einer Linie</translation>
        </message>
        <message>
            <source>on a plane</source>
            <translation>auf einer Ebene</translation>
        </message>
        <message>
            <source>on its vertical line</source>
            <translation>auf ihrer lotrechten Linie</translation>
        </message>
        <message>
            <source>on its vertical plane</source>
            <translation>auf ihrer lotrechten Ebene</translation>
        </message>
        <message>
            <source>point loads</source>
            <translation>Einzellasten</translation>
        </message>
        <message>
            <source>present</source>
            <translation>jetzt</translation>
        </message>
        <message>
            <source>range is fixed</source>
            <translation>Bereich ist fest</translation>
        </message>
        <message>
            <source>residual {:.0e}</source>
            <translation>Residuum {:.0e}</translation>
        </message>
        <message>
            <source>rigid</source>
            <translation>starr</translation>
        </message>
        <message>
            <source>selected edge or face</source>
            <translation>gewählte Kante oder Fläche</translation>
        </message>
        <message>
            <source>slack</source>
            <translation>schlaff</translation>
        </message>
        <message>
            <source>slack, carries nothing</source>
            <translation>schlaff, trägt nichts</translation>
        </message>
        <message>
            <source>snow</source>
            <translation>Schnee</translation>
        </message>
        <message>
            <source>tension</source>
            <translation>Zug</translation>
        </message>
        <message>
            <source>tension +</source>
            <translation>Zug +</translation>
        </message>
        <message>
            <source>tension + (own scale)</source>
            <translation>Zug + (eigener Maßstab)</translation>
        </message>
        <message>
            <source>the covering</source>
            <translation>Eindeckung</translation>
        </message>
        <message>
            <source>the members' stiffness</source>
            <translation>Stabsteifigkeit</translation>
        </message>
        <message>
            <source>the members' weight</source>
            <translation>Stabgewicht</translation>
        </message>
        <message>
            <source>the solve was cancelled and the last good shape stays; recompute to solve again</source>
            <translation>das Lösen wurde abgebrochen, und die letzte gute Form bleibt; neu berechnen, um wieder zu lösen</translation>
        </message>
        <message>
            <source>time in the solver</source>
            <translation>Zeit im Löser</translation>
        </message>
        <message>
            <source>to</source>
            <translation>bis</translation>
        </message>
        <message>
            <source>too much</source>
            <translation>zu viel</translation>
        </message>
        <message>
            <source>too much (own scale)</source>
            <translation>zu viel (eigener Maßstab)</translation>
        </message>
        <message>
            <source>up</source>
            <translation>aufwärts</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>ja</translation>
        </message>
        <message>
            <source>z, upright</source>
            <translation>z, lotrecht</translation>
        </message>
        <message>
            <source>{} % faster</source>
            <translation>{} % schneller</translation>
        </message>
        <message>
            <source>{} % slower</source>
            <translation>{} % langsamer</translation>
        </message>
        <message>
            <source>{} Accuracy and method are as before.</source>
            <translation>{} Genauigkeit und Verfahren sind wie zuvor.</translation>
        </message>
        <message>
            <source>{} and {} are written.</source>
            <translation>{} und {} sind geschrieben.</translation>
        </message>
        <message>
            <source>{} bodies or nets are selected, and a gridshell stands on one. Select faces of a single body in the 3D view, then run Gridshell again.</source>
            <translation>{} Körper oder Netze sind gewählt, und eine Gitterschale steht auf einem. Flächen eines einzigen Körpers in der 3D-Ansicht wählen, dann Gitterschale erneut ausführen.</translation>
        </message>
        <message>
            <source>{} by {}: {}, truly {}</source>
            <translation>{} mit {}: {}, in Wahrheit {}</translation>
        </message>
        <message>
            <source>{} downward</source>
            <translation>{} abwärts</translation>
        </message>
        <message>
            <source>{} edges and faces are selected: select one, in the model or the 3D view.</source>
            <translation>{} Kanten und Flächen sind gewählt: eine wählen, im Modell oder in der 3D-Ansicht.</translation>
        </message>
        <message>
            <source>{} follows the expression {}: change that instead.</source>
            <translation>{} folgt dem Ausdruck {}: stattdessen diesen ändern.</translation>
        </message>
        <message>
            <source>{} from equilibrium</source>
            <translation>{} vom Gleichgewicht</translation>
        </message>
        <message>
            <source>{} from the source</source>
            <translation>{} von der Quelle</translation>
        </message>
        <message>
            <source>{} gave up after {}, without coming as near as {}.</source>
            <translation>{} gab nach {} auf, ohne auf {} heranzukommen.</translation>
        </message>
        <message>
            <source>{} gridshells are selected, and this is done for one. Select a single Gridshell in the tree, then run the command again.</source>
            <translation>{} Gitterschalen sind gewählt, und dies geschieht für eine. Eine einzige im Baum wählen, dann den Befehl erneut ausführen.</translation>
        </message>
        <message>
            <source>{} has another net: restore it to see it.</source>
            <translation>{} hat ein anderes Netz: wiederherstellen, um es zu sehen.</translation>
        </message>
        <message>
            <source>{} is selected as a whole, with {} faces: select those that the gridshell shall follow, in the 3D view.</source>
            <translation>{} ist als Ganzes gewählt, mit {} Flächen: die in der 3D-Ansicht wählen, denen die Gitterschale folgen soll.</translation>
        </message>
        <message>
            <source>{} is shown, as it was kept. Esc shows the present form again.</source>
            <translation>{} ist zu sehen, wie sie behalten wurde. Esc zeigt wieder die jetzige Form.</translation>
        </message>
        <message>
            <source>{} is there already. Replace it?</source>
            <translation>{} gibt es schon. Ersetzen?</translation>
        </message>
        <message>
            <source>{} members are in tension.</source>
            <translation>{} Stäbe stehen unter Zug.</translation>
        </message>
        <message>
            <source>{} members are slack: they carry nothing.</source>
            <translation>{} Stäbe sind schlaff: sie tragen nichts.</translation>
        </message>
        <message>
            <source>{} of {} is not what the net lies on: select edges of its source.</source>
            <translation>{} von {} ist nicht, worauf das Netz liegt: Kanten seiner Quelle wählen.</translation>
        </message>
        <message>
            <source>{} of {} measured</source>
            <translation>{} von {} gemessen</translation>
        </message>
        <message>
            <source>{} of {} members in tension, at most {}</source>
            <translation>{} von {} Stäben unter Zug, höchstens {}</translation>
        </message>
        <message>
            <source>{} overall: step {}, {}</source>
            <translation type="vanished">{} insgesamt: Schritt {}, {}</translation>
        </message>
        <message>
            <source>{} sideways</source>
            <translation>{} seitwärts</translation>
        </message>
        <message>
            <source>{} supports pull the shell down, so it pulls upward there.</source>
            <translation>{} Auflager ziehen die Schale nach unten, sie zieht dort also aufwärts.</translation>
        </message>
        <message>
            <source>{} total, balanced to {:.0e}</source>
            <translation>{} insgesamt, ausgeglichen bis auf {:.0e}</translation>
        </message>
        <message>
            <source>{} upward</source>
            <translation>{} aufwärts</translation>
        </message>
        <message>
            <source>{}, at {}</source>
            <translation>{}, bei {}</translation>
        </message>
        <message>
            <source>{}, {} iterations</source>
            <translation>{}, {} Iterationen</translation>
        </message>
        <message>
            <source>{}, {} node</source>
            <translation>{}, {} Knoten</translation>
        </message>
        <message>
            <source>{}, {} nodes</source>
            <translation>{}, {} Knoten</translation>
        </message>
        <message>
            <source>{}. Chosen: the gridshell was solved again in {}.</source>
            <translation>{}. Gewählt: die Gitterschale wurde in {} neu gelöst.</translation>
        </message>
        <message>
            <source>{}. The gridshell has this accuracy and method.</source>
            <translation>{}. Die Gitterschale hat diese Genauigkeit und dieses Verfahren.</translation>
        </message>
        <message>
            <source>{}: {} %, Esc cancels</source>
            <translation>{}: {} %, Esc bricht ab</translation>
        </message>
        <message>
            <source>{}: {}, {} % of the time, {} calls, {} kB.</source>
            <translation>{}: {}, {} % der Zeit, {} Aufrufe, {} kB.</translation>
        </message>
        <message>
            <source>{}: {}, {} nodes</source>
            <translation>{}: {}, {} Knoten</translation>
        </message>
        <message>
            <source>“{}” is negative: give more than zero.</source>
            <translation>„{}“ ist negativ: mehr als null angeben.</translation>
        </message>
        <message>
            <source>“{}” is not a value in {}. Write for example “12 {}”.</source>
            <translation>„{}“ ist kein Wert in {}. Zum Beispiel „12 {}“ schreiben.</translation>
        </message>
    </context>
    <context>
        <name>FunicularPreferences</name>
        <message>
            <source>&amp;Accuracy</source>
            <translation>&amp;Genauigkeit</translation>
        </message>
        <message>
            <source>&amp;Colours of forces</source>
            <translation>&amp;Farben der Kräfte</translation>
        </message>
        <message>
            <source>&amp;Time for a frame</source>
            <translation>&amp;Zeit für ein Bild</translation>
        </message>
        <message>
            <source>As the unit schema (N and kN, or lbf and kip)</source>
            <translation>Wie das Einheitensystem (N und kN, oder lbf und kip)</translation>
        </message>
        <message>
            <source>Blue for compression, orange for tension</source>
            <translation>Blau für Druck, Orange für Zug</translation>
        </message>
        <message>
            <source>From one frame to the next while a form moves; more leaves more of the processor to the solver. Counts from the next time that a panel opens.</source>
            <translation>Von einem Bild zum nächsten, während sich eine Form bewegt; mehr lässt dem Löser mehr vom Prozessor. Zählt, wenn das nächste Mal ein Panel öffnet.</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Allgemein</translation>
        </message>
        <message>
            <source>How far from equilibrium the nodes of a new gridshell may lie</source>
            <translation>Wie weit die Knoten einer neuen Gitterschale vom Gleichgewicht entfernt sein dürfen</translation>
        </message>
        <message>
            <source>New gridshells</source>
            <translation>Neue Gitterschalen</translation>
        </message>
        <message>
            <source>Numbers and colours</source>
            <translation>Zahlen und Farben</translation>
        </message>
        <message>
            <source>One ramp, from dark to light</source>
            <translation>Ein Verlauf, von dunkel nach hell</translation>
        </message>
        <message>
            <source>Panel of a gridshell</source>
            <translation>Panel einer Gitterschale</translation>
        </message>
        <message>
            <source>Show the form as it &amp;moves</source>
            <translation>Die Form &amp;bewegt zeigen</translation>
        </message>
        <message>
            <source>Show the form on its way, at an even pace. Without it each form is shown where it comes to.</source>
            <translation>Die Form auf ihrem Weg zeigen, in gleichmäßigem Tempo. Sonst steht jede Form gleich da, wo sie hinkommt.</translation>
        </message>
        <message>
            <source>The colours of the members in the 3D view. Both are told apart with any colour vision.</source>
            <translation>Die Farben der Stäbe in der 3D-Ansicht. Beide sind bei jeder Farbsicht zu unterscheiden.</translation>
        </message>
        <message>
            <source>The unit that forces are written in: in sentences, in the legend and in the panel</source>
            <translation>Die Einheit, in der Kräfte geschrieben werden: in Sätzen, in der Legende und im Panel</translation>
        </message>
        <message>
            <source>Unit of &amp;force</source>
            <translation>&amp;Krafteinheit</translation>
        </message>
    </context>
    <context>
        <name>Funicular_AccuracyStudy</name>
        <message>
            <source>A plot grows beside the 3D view, and nothing waits for it. Click a point of it, and the gridshell takes that accuracy and method.</source>
            <translation>Neben der 3D-Ansicht wächst ein Diagramm, und nichts wartet darauf. Einen Punkt darin anklicken, und die Gitterschale übernimmt diese Genauigkeit und dieses Verfahren.</translation>
        </message>
        <message>
            <source>Measure how long the selected gridshell takes at several accuracies, and choose one.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation>Messen, wie lange die gewählte Gitterschale bei mehreren Genauigkeiten braucht, und eine wählen.
Eine Gitterschale im Baum oder in der 3D-Ansicht wählen, dann diesen Befehl ausführen.</translation>
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation>Was Genauigkeit kostet</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Covering</name>
        <message>
            <source>Cover the panels of the selected gridshell with faces.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation>Die Felder der gewählten Gitterschale mit Flächen eindecken.
Eine Gitterschale im Baum oder in der 3D-Ansicht wählen, dann diesen Befehl ausführen.</translation>
        </message>
        <message>
            <source>Covering</source>
            <translation>Eindeckung</translation>
        </message>
        <message>
            <source>Each panel becomes a face that other commands of FreeCAD can use and that STEP files take. The Covering says which panels are warped and by how much, and follows the gridshell.</source>
            <translation>Jedes Feld wird eine Fläche, die andere Befehle von FreeCAD und STEP-Dateien nehmen. Die Eindeckung sagt, welche Felder verwunden sind und wie sehr, und folgt der Gitterschale.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Gridshell</name>
        <message>
            <source>A net is laid on the face and relaxed until each member is compressed. The panel that opens has its steps, weights and supports. Shape and numbers follow the face from then on.</source>
            <translation>Auf die Fläche wird ein Netz gelegt und entspannt, bis jeder Stab unter Druck steht. Das Panel, das sich öffnet, hat seine Schritte, Gewichte und Auflager. Form und Zahlen folgen der Fläche von da an.</translation>
        </message>
        <message>
            <source>Gridshell</source>
            <translation>Gitterschale</translation>
        </message>
        <message>
            <source>Turn the selected face into a compression-only gridshell.
Select a face in the 3D view, several of one body, or a Net in the tree, then run this command.</source>
            <translation>Aus der gewählten Fläche eine Gitterschale machen, die nur unter Druck steht.
Eine Fläche in der 3D-Ansicht wählen, mehrere eines Körpers, oder ein Netz im Baum, dann diesen Befehl ausführen.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Guide</name>
        <message>
            <source>Funicular guide</source>
            <translation>Anleitung zu Funicular</translation>
        </message>
        <message>
            <source>The guide opens in a window of its own and needs no network.</source>
            <translation>Die Anleitung öffnet in einem eigenen Fenster und braucht keine Internetverbindung. Sie ist auf Englisch.</translation>
        </message>
        <message>
            <source>Two pages with pictures: from a face to a gridshell and out.</source>
            <translation>Zwei Seiten mit Bildern: von der Fläche zur Gitterschale und hinaus.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_PointLoad</name>
        <message>
            <source>Point load</source>
            <translation>Einzellast</translation>
        </message>
        <message>
            <source>Put a load of 1 kN on each of the selected nodes.
Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.</source>
            <translation>Eine Last von 1 kN auf jeden ausgewählten Knoten setzen.
Eine Gitterschale auswählen und dazu eigene Knoten oder Kanten und Punkte ihrer Quelle.</translation>
        </message>
        <message>
            <source>The load is an object of its own below the Gridshell, with Force and Direction as properties, and keeps its place on the face, whatever the step. The shell is relaxed with it.</source>
            <translation>Die Last ist ein eigenes Objekt unter der Gitterschale, mit Kraft und Richtung als Eigenschaften, und behält ihren Ort auf der Fläche, wie groß die Schrittweite auch ist. Die Schale wird mit ihr gefunden.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Raise</name>
        <message>
            <source>Raise</source>
            <translation>Heben</translation>
        </message>
        <message>
            <source>Raise the selected nodes of the net by a quarter of a member, and again for more.
Select nodes of a Gridshell. The height of each is in the property Raised of its Net.</source>
            <translation>Die gewählten Knoten des Netzes um ein Viertel eines Stabes heben, und erneut für mehr.
Knoten einer Gitterschale wählen. Die Höhe jedes Knotens steht in der Eigenschaft Raised ihres Netzes.</translation>
        </message>
        <message>
            <source>The gridshell is relaxed again on the net that was changed. Undo takes it back.</source>
            <translation>Die Gitterschale wird auf dem geänderten Netz neu entspannt. Rückgängig nimmt es zurück.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Sheet</name>
        <message>
            <source>Flat sheet</source>
            <translation>Ebenes Netz</translation>
        </message>
        <message>
            <source>Start from a flat sheet of given size, which rises between its four corners.
Nothing needs to be selected.</source>
            <translation>Mit einem ebenen Netz gegebener Größe beginnen, das sich zwischen seinen vier Ecken hebt.
Es muss nichts gewählt sein.</translation>
        </message>
        <message>
            <source>The sheet stands on its four corners and rises between them. The panel that opens has its width, its depth and all else that a gridshell has.</source>
            <translation>Das Netz steht auf seinen vier Ecken und hebt sich zwischen ihnen. Das Panel, das sich öffnet, hat seine Breite, seine Tiefe und alles, was eine Gitterschale sonst hat.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Support</name>
        <message>
            <source>Hold the selected gridshell at its border, or where edges and vertices are selected too.
Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.</source>
            <translation>Die gewählte Gitterschale an ihrem Rand halten, oder wo auch Kanten und Eckpunkte gewählt sind.
Eine Gitterschale wählen, und dazu Knoten von ihr oder Kanten und Eckpunkte ihrer Quelle.</translation>
        </message>
        <message>
            <source>Support</source>
            <translation>Auflager</translation>
        </message>
        <message>
            <source>The new Support stands in the tree, and its properties say how it holds its nodes: fixed, sliding in a plane or on a line, yielding, or not at all. It outlives other steps of the net.</source>
            <translation>Das neue Auflager steht im Baum, und seine Eigenschaften sagen, wie es seine Knoten hält: fest, gleitend in einer Ebene oder auf einer Linie, nachgiebig, oder gar nicht. Es überdauert andere Schritte des Netzes.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_TakeOut</name>
        <message>
            <source>Take out</source>
            <translation>Herausnehmen</translation>
        </message>
        <message>
            <source>Take the selected members out of the net, or the panels whose faces are selected.
Select members of a Gridshell, or faces of its Covering. Their place on the face is kept.</source>
            <translation>Die gewählten Stäbe aus dem Netz nehmen, oder die Felder, deren Flächen gewählt sind.
Stäbe einer Gitterschale wählen, oder Flächen ihrer Eindeckung. Ihr Ort auf der Fläche wird behalten.</translation>
        </message>
        <message>
            <source>The covering of an opening stands on its rim. The gridshell is relaxed again. Undo takes it back.</source>
            <translation>Die Eindeckung einer Öffnung steht auf deren Rand. Die Gitterschale wird neu entspannt. Rückgängig nimmt es zurück.</translation>
        </message>
    </context>
    <context>
        <name>Workbench</name>
        <message>
            <source>Funicular</source>
            <translation>Funicular</translation>
        </message>
        <message>
            <source>Turn a surface into a compression-only gridshell</source>
            <translation>Aus einer Fläche eine Gitterschale machen, die nur unter Druck steht</translation>
        </message>
    </context>
</TS>
