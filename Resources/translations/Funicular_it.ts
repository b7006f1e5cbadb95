<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="it" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>(u, v) of each node that is on no lattice</source>
            <translation>(u, v) di ogni nodo che non sta su una griglia</translation>
        </message>
        <message>
            <source>(u, v) of the face between 0 and 1 (z is not used): the node nearest to each</source>
            <translation type="vanished">(u, v) della faccia tra 0 e 1 (z non conta): il nodo più vicino a ciascuno</translation>
        </message>
        <message>
            <source>(u, v) of the face, between 0 and 1, that a net of equal lengths grows from</source>
            <translation>(u, v) della faccia, tra 0 e 1, da cui cresce un reticolo di aste uguali</translation>
        </message>
        <message>
            <source>(u, v) on the face: the nearest member is taken out, and the panels beside it are one</source>
            <translation>(u, v) sulla faccia: l'asta più vicina è tolta e i pannelli accanto diventano uno</translation>
        </message>
        <message>
            <source>(u, v) on the face: the nearest panel becomes an opening</source>
            <translation>(u, v) sulla faccia: il pannello più vicino diventa un'apertura</translation>
        </message>
        <message>
            <source>(u, v, height in mm): the node nearest to (u, v) on the face is raised, or lowered</source>
            <translation>(u, v, altezza in mm): il nodo più vicino a (u, v) sulla faccia è alzato o abbassato</translation>
        </message>
        <message>
            <source>A mesh file (obj, ply, stl, off) that is taken as it is, where there is no source</source>
            <translation>Un file di mesh (obj, ply, stl, off) preso com'è, dove non c'è una sorgente</translation>
        </message>
        <message>
            <source>Along the isolines of the face, or with a compass, so that all members have the length of StepU</source>
            <translation>Lungo le isolinee della faccia, oppure col compasso, così che tutte le aste abbiano la lunghezza StepU</translation>
        </message>
        <message>
            <source>Area of each opening on the source [mm²]</source>
            <translation>Area di ogni apertura sulla sorgente [mm²]</translation>
        </message>
        <message>
            <source>Area that the covering's weight counts: of triangles about the mean of each panel's corners</source>
            <translation>Area che conta per il peso della copertura: dei triangoli attorno al centro dei vertici di ogni pannello</translation>
        </message>
        <message>
            <source>Between members at the start</source>
            <translation>Tra le aste all'inizio</translation>
        </message>
        <message>
            <source>By how many cells the pattern is shifted along u</source>
            <translation>Di quante celle il motivo è spostato lungo u</translation>
        </message>
        <message>
            <source>By how many cells the pattern is shifted along v</source>
            <translation>Di quante celle il motivo è spostato lungo v</translation>
        </message>
        <message>
            <source>By how much each of RaisedNodes is raised [mm]</source>
            <translation>Di quanto è alzato ciascuno dei RaisedNodes [mm]</translation>
        </message>
        <message>
            <source>By which the pattern is turned on the face</source>
            <translation>Di cui il motivo è ruotato sulla faccia</translation>
        </message>
        <message>
            <source>Cells along u, in place of StepU; 0 for none</source>
            <translation>Celle lungo u, al posto di StepU; 0 per nessuna</translation>
        </message>
        <message>
            <source>Cells along v, in place of StepV; 0 for none</source>
            <translation>Celle lungo v, al posto di StepV; 0 per nessuna</translation>
        </message>
        <message>
            <source>Colour by the range that is given, unless its ends are equal</source>
            <translation>Colorare secondo l'intervallo dato, a meno che i suoi estremi siano uguali</translation>
        </message>
        <message>
            <source>Curved edges are divided into parts no longer than this; 0 for one member each</source>
            <translation>Gli spigoli curvi sono divisi in parti non più lunghe di questo; 0 per una sola asta ciascuno</translation>
        </message>
        <message>
            <source>Diameter of round bars, and width of rectangular ones</source>
            <translation type="vanished">Diametro delle aste tonde e larghezza di quelle rettangolari</translation>
        </message>
        <message>
            <source>Diameter of round bars, width of others; where such a section is given, its own</source>
            <translation>Diametro delle barre tonde, larghezza delle altre; se è data una tale sezione, la sua</translation>
        </message>
        <message>
            <source>Diameter of round members, width of others</source>
            <translation>Diametro delle aste tonde, larghezza delle altre</translation>
        </message>
        <message>
            <source>EA of the members, the force that would double their length: the lower, the higher the shell</source>
            <translation>EA delle aste, la forza che ne raddoppierebbe la lunghezza: più è bassa, più alta è la gridshell</translation>
        </message>
        <message>
            <source>Edges and vertices of the net's source, such as Edge3 or Vertex1: every node on them</source>
            <translation type="vanished">Spigoli e vertici della sorgente del reticolo, come Edge3 o Vertex1: ogni nodo su di essi</translation>
        </message>
        <message>
            <source>Edges and vertices of the source that hold nodes</source>
            <translation>Spigoli e vertici della sorgente su cui stanno nodi</translation>
        </message>
        <message>
            <source>Faces: plane where a panel is plane, ruled on warped quads, triangles on other warped panels; Ruled faces: ruled on every quad; Triangles: between edges and the mean of the corners</source>
            <translation>Faces: piane dove il pannello è piano, rigate sui quadrilateri svergolati, triangoli sugli altri pannelli svergolati; Ruled faces: rigate su ogni quadrilatero; Triangles: tra i lati e il centro dei vertici</translation>
        </message>
        <message>
            <source>Force for each length that the support yields; 0 for one that does not</source>
            <translation type="vanished">Forza per ogni lunghezza di cui il vincolo cede; 0 per uno che non cede</translation>
        </message>
        <message>
            <source>Force in each member [N], compression negative</source>
            <translation>Forza in ogni asta [N], compressione negativa</translation>
        </message>
        <message>
            <source>Forces on single nodes, besides all weights</source>
            <translation>Forze su singoli nodi, oltre a tutti i pesi</translation>
        </message>
        <message>
            <source>Give up after this time; 0 for never</source>
            <translation>Rinunciare dopo questo tempo; 0 per mai</translation>
        </message>
        <message>
            <source>Height of rectangular bars, in the vertical plane of each</source>
            <translation type="vanished">Altezza delle aste rettangolari, nel piano verticale di ciascuna</translation>
        </message>
        <message>
            <source>Height of rectangular bars, upright; where such a section is given, its own</source>
            <translation>Altezza delle barre rettangolari, in piedi; se è data una tale sezione, la sua</translation>
        </message>
        <message>
            <source>Height of rectangular members</source>
            <translation>Altezza delle aste rettangolari</translation>
        </message>
        <message>
            <source>How a panel's weight goes to its corners: by their angles, equally, by the area nearest to each</source>
            <translation>Come il peso di un pannello va ai suoi vertici: secondo gli angoli, in parti uguali, secondo l'area più vicina a ciascuno</translation>
        </message>
        <message>
            <source>How far a corner may lie from the best plane of a panel that counts as plane</source>
            <translation>Quanto un vertice può distare dal piano medio di un pannello che conta come piano</translation>
        </message>
        <message>
            <source>How far from equilibrium the nodes may lie</source>
            <translation>Quanto i nodi possono distare dall'equilibrio</translation>
        </message>
        <message>
            <source>How far the angle between members may be from a right one; there the net ends</source>
            <translation>Quanto l'angolo tra le aste può scostarsi da quello retto; lì il reticolo finisce</translation>
        </message>
        <message>
            <source>How far the nodes still are from equilibrium</source>
            <translation>Quanto i nodi distano ancora dall'equilibrio</translation>
        </message>
        <message>
            <source>How high the sun stands above the horizon; below 5° it is taken for 5°</source>
            <translation>Quanto è alto il sole sull'orizzonte; sotto 5° vale 5°</translation>
        </message>
        <message>
            <source>How many times larger than it is the way from the source is drawn: 1 to 20</source>
            <translation>Quante volte più grande del vero è disegnata la distanza dalla sorgente: da 1 a 20</translation>
        </message>
        <message>
            <source>How members are laid on the face</source>
            <translation>Come le aste stanno sulla faccia</translation>
        </message>
        <message>
            <source>How nodes are held; Free takes them from the other supports</source>
            <translation type="vanished">Come sono tenuti i nodi; Free li toglie agli altri vincoli</translation>
        </message>
        <message>
            <source>How the last recompute ended: converged; failed; or the limit that the solver met</source>
            <translation>Come è finito l'ultimo ricalcolo: converged; failed; o il limite incontrato dal solutore</translation>
        </message>
        <message>
            <source>Iterations of the solver</source>
            <translation>Iterazioni del solutore</translation>
        </message>
        <message>
            <source>Largest distance of a corner from its best plane</source>
            <translation>Massima distanza di un vertice dal suo piano medio</translation>
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation>Massima trazione in un'asta</translation>
        </message>
        <message>
            <source>Largest unbalanced force at a node, in mean nodal loads</source>
            <translation>Massima forza non equilibrata in un nodo, in carichi nodali medi</translation>
        </message>
        <message>
            <source>Lay the pattern over the mesh of File by its UV coordinates, instead of taking its own edges</source>
            <translation>Stendere il motivo sulla mesh del file con le sue coordinate UV, invece di prenderne gli spigoli</translation>
        </message>
        <message>
            <source>Length of members along u, measured on the face</source>
            <translation>Lunghezza delle aste lungo u, misurata sulla faccia</translation>
        </message>
        <message>
            <source>Length of members along v, measured on the face</source>
            <translation>Lunghezza delle aste lungo v, misurata sulla faccia</translation>
        </message>
        <message>
            <source>Let members carry tension too; otherwise those that would go slack</source>
            <translation>Le aste possono portare anche trazione; altrimenti quelle tese restano scariche</translation>
        </message>
        <message>
            <source>Members in tension, counted from 0</source>
            <translation>Aste in trazione, contate da 0</translation>
        </message>
        <message>
            <source>Members that are taken out, by number</source>
            <translation>Aste tolte, per numero</translation>
        </message>
        <message>
            <source>Members without force: they can be left out</source>
            <translation>Aste senza forza: si possono togliere</translation>
        </message>
        <message>
            <source>Newton is fast; relaxation is the method of Brivio et al. (2009); auto chooses</source>
            <translation>Newton è veloce; Relaxation è il metodo di Brivio et al. (2009); Auto sceglie</translation>
        </message>
        <message>
            <source>No member is in tension: recomputed from the result</source>
            <translation>Nessuna asta è in trazione: ricalcolato dal risultato</translation>
        </message>
        <message>
            <source>Nodes on the face, in the numbering of the net</source>
            <translation>Nodi sulla faccia, nella numerazione del reticolo</translation>
        </message>
        <message>
            <source>Normal of the plane, or direction of the line</source>
            <translation type="vanished">Normale del piano, o direzione della linea</translation>
        </message>
        <message>
            <source>Number of cells along u</source>
            <translation>Numero di celle lungo u</translation>
        </message>
        <message>
            <source>Number of cells along v</source>
            <translation>Numero di celle lungo v</translation>
        </message>
        <message>
            <source>Number of members</source>
            <translation>Numero di aste</translation>
        </message>
        <message>
            <source>Number of nodes</source>
            <translation>Numero di nodi</translation>
        </message>
        <message>
            <source>Number of panels</source>
            <translation>Numero di pannelli</translation>
        </message>
        <message>
            <source>Number of panels that are plane</source>
            <translation>Numero di pannelli piani</translation>
        </message>
        <message>
            <source>Numbers of nodes before edits, for a net that keeps them</source>
            <translation type="vanished">Numeri di nodi prima delle modifiche, per un reticolo che li conserva</translation>
        </message>
        <message>
            <source>Numbers of nodes, for nets that keep them</source>
            <translation>Numeri di nodi, per reticoli che li conservano</translation>
        </message>
        <message>
            <source>Of a flat sheet, where there is no source</source>
            <translation>Di un foglio piano, dove non c'è una sorgente</translation>
        </message>
        <message>
            <source>Of each border of a hole how many nodes, then these</source>
            <translation>Di ogni bordo di un foro quanti nodi, poi questi</translation>
        </message>
        <message>
            <source>Of each how many nodes, then their numbers</source>
            <translation>Di ciascuno quanti nodi, poi i loro numeri</translation>
        </message>
        <message>
            <source>Of each opening how many nodes, then their numbers</source>
            <translation>Di ogni apertura quanti nodi, poi i loro numeri</translation>
        </message>
        <message>
            <source>Of each panel how many nodes, then their numbers</source>
            <translation>Di ogni pannello quanti nodi, poi i loro numeri</translation>
        </message>
        <message>
            <source>Panels that are not plane, counted from 0</source>
            <translation>Pannelli non piani, contati da 0</translation>
        </message>
        <message>
            <source>Panels that become openings, by number</source>
            <translation>Pannelli che diventano aperture, per numero</translation>
        </message>
        <message>
            <source>Reaction at each node [N], before Placement; zero where unsupported</source>
            <translation>Reazione a ogni nodo [N], prima del posizionamento; zero dove non c'è vincolo</translation>
        </message>
        <message>
            <source>Relaxed position of each node [mm], before Placement</source>
            <translation>Posizione di ogni nodo in equilibrio [mm], prima del posizionamento</translation>
        </message>
        <message>
            <source>Root mean square of the members' relative difference from their lengths on the source</source>
            <translation>Scarto quadratico medio relativo delle aste dalle loro lunghezze sulla sorgente</translation>
        </message>
        <message>
            <source>Rounds that bring the members back to their lengths on the source; 0 for none</source>
            <translation>Cicli che riportano le aste alle loro lunghezze sulla sorgente; 0 per nessuno</translation>
        </message>
        <message>
            <source>Shape of the solid members across, for their stress; it does not change the form</source>
            <translation>Forma della sezione piena delle aste, per la loro tensione; non cambia la forma della gridshell</translation>
        </message>
        <message>
            <source>Show level ground at the lowest node, and the shadow on it</source>
            <translation>Mostrare il terreno piano al nodo più basso, e l'ombra su di esso</translation>
        </message>
        <message>
            <source>Show level ground at the lowest support, and the shadow on it</source>
            <translation type="vanished">Mostrare il terreno piano al vincolo più basso, e l'ombra su di esso</translation>
        </message>
        <message>
            <source>Show the net as it was laid, pale, beside what it has become</source>
            <translation>Mostrare il reticolo com'era steso, pallido, accanto a ciò che è diventato</translation>
        </message>
        <message>
            <source>Show the reactions as arrows, all to one scale</source>
            <translation>Mostrare le reazioni come frecce, tutte nella stessa scala</translation>
        </message>
        <message>
            <source>Show what each colour stands for</source>
            <translation>Mostrare che cosa significa ogni colore</translation>
        </message>
        <message>
            <source>Sides of the face that are one point</source>
            <translation>Lati della faccia che sono un punto</translation>
        </message>
        <message>
            <source>Snow load on plan; 0 for none</source>
            <translation>Carico di neve in pianta; 0 per nessuno</translation>
        </message>
        <message>
            <source>Stress that the members bear, for their utilisation; 0 for unknown</source>
            <translation>Tensione che le aste sopportano, per il loro sfruttamento; 0 per ignota</translation>
        </message>
        <message>
            <source>Sum of all loads, downwards</source>
            <translation>Somma di tutti i carichi, verso il basso</translation>
        </message>
        <message>
            <source>Sum of all reactions, upwards</source>
            <translation>Somma di tutte le reazioni, verso l'alto</translation>
        </message>
        <message>
            <source>Supports of their own, besides those of the recipe</source>
            <translation>Vincoli propri, oltre a quelli dello schema</translation>
        </message>
        <message>
            <source>Take its nodes from the supports before it in the gridshell's list, instead of adding to them</source>
            <translation type="vanished">Togliere i suoi nodi ai vincoli che lo precedono nella lista della gridshell, invece di aggiungersi</translation>
        </message>
        <message>
            <source>The face or faces that the net lies on</source>
            <translation>La faccia o le facce su cui sta il reticolo</translation>
        </message>
        <message>
            <source>The gridshell whose panels these are</source>
            <translation>La gridshell di cui questi sono i pannelli</translation>
        </message>
        <message>
            <source>The last cell along u joins the first</source>
            <translation>L'ultima cella lungo u si unisce alla prima</translation>
        </message>
        <message>
            <source>The last cell along v joins the first</source>
            <translation>L'ultima cella lungo v si unisce alla prima</translation>
        </message>
        <message>
            <source>The method that found the result</source>
            <translation>Il metodo che ha trovato il risultato</translation>
        </message>
        <message>
            <source>The net that is relaxed; several gridshells may share one</source>
            <translation>Il reticolo di cui si trova la forma; più gridshell possono condividerne uno</translation>
        </message>
        <message>
            <source>The net whose nodes are held</source>
            <translation type="vanished">Il reticolo di cui sono tenuti i nodi</translation>
        </message>
        <message>
            <source>The nodes around each panel: of each panel how many, then their numbers</source>
            <translation>I nodi attorno a ogni pannello: di ogni pannello quanti, poi i loro numeri</translation>
        </message>
        <message>
            <source>The nodes of each member: two numbers a member, counted from 0</source>
            <translation>I nodi di ogni asta: due numeri per asta, contati da 0</translation>
        </message>
        <message>
            <source>The pattern that the nodes were laid in</source>
            <translation>Il motivo in cui i nodi sono stati stesi</translation>
        </message>
        <message>
            <source>The result in a sentence</source>
            <translation>Il risultato in una frase</translation>
        </message>
        <message>
            <source>Time in the solver</source>
            <translation>Tempo nel solutore</translation>
        </message>
        <message>
            <source>Turn the pattern: what ran along u runs along v</source>
            <translation>Ruotare il motivo: ciò che correva lungo u corre lungo v</translation>
        </message>
        <message>
            <source>Two nodes a member; empty for a lattice</source>
            <translation>Due nodi per asta; vuoto per una griglia</translation>
        </message>
        <message>
            <source>Unit of the lengths in File</source>
            <translation>Unità delle lunghezze in File</translation>
        </message>
        <message>
            <source>Version of the set of properties of this object</source>
            <translation>Versione delle proprietà di questo oggetto</translation>
        </message>
        <message>
            <source>Vertices of a mesh as near as this are one node; 0 for 1e-6 of its size</source>
            <translation>I vertici di una mesh vicini così sono un nodo; 0 per 1e-6 della sua dimensione</translation>
        </message>
        <message>
            <source>Weight of the covering per area; 0 for none</source>
            <translation>Peso della copertura per area; 0 per nessuno</translation>
        </message>
        <message>
            <source>Weight of the members per length; 0 for none</source>
            <translation>Peso delle aste per lunghezza; 0 per nessuno</translation>
        </message>
        <message>
            <source>What came out otherwise</source>
            <translation>Che cosa è risultato diverso dal richiesto</translation>
        </message>
        <message>
            <source>What each of SourceElements is</source>
            <translation>Che cosa è ciascuno dei SourceElements</translation>
        </message>
        <message>
            <source>What is drawn of the gridshell: members, its covering, or both</source>
            <translation>Che cosa si disegna della gridshell: aste, copertura o entrambe</translation>
        </message>
        <message>
            <source>What is equal from cell to cell: the length on the face, or the surface's parameters</source>
            <translation>Che cosa è uguale da cella a cella: la lunghezza sulla faccia, o i parametri della superficie</translation>
        </message>
        <message>
            <source>What the colour of each member stands for</source>
            <translation>Che cosa significa il colore di ogni asta</translation>
        </message>
        <message>
            <source>What the elements were when they were picked</source>
            <translation type="vanished">Che cosa erano gli elementi quando furono scelti</translation>
        </message>
        <message>
            <source>What the face belonged to when it was picked</source>
            <translation>A che cosa apparteneva la faccia quando fu scelta</translation>
        </message>
        <message>
            <source>What this object is to Funicular</source>
            <translation>Che cosa è questo oggetto per Funicular</translation>
        </message>
        <message>
            <source>What was found</source>
            <translation type="vanished">Che cosa è stato trovato</translation>
        </message>
        <message>
            <source>What was kept of this gridshell under a name, see funicular.features.variants</source>
            <translation>Che cosa di questa gridshell è stato conservato con un nome, vedi funicular.features.variants</translation>
        </message>
        <message>
            <source>Where a fixed range of this colouring begins (utilisation in %)</source>
            <translation>Dove comincia un intervallo fisso di questi colori (sfruttamento in %)</translation>
        </message>
        <message>
            <source>Where a fixed range of this colouring ends (utilisation in %)</source>
            <translation>Dove finisce un intervallo fisso di questi colori (sfruttamento in %)</translation>
        </message>
        <message>
            <source>Where the shell stands</source>
            <translation>Dove sta la gridshell</translation>
        </message>
        <message>
            <source>Where the sun stands, from north (y) clockwise: 180° is in the south</source>
            <translation>Dove sta il sole, da nord (y) in senso orario: 180° è sud</translation>
        </message>
        <message>
            <source>Whether that was turned</source>
            <translation>Se era ruotato</translation>
        </message>
        <message>
            <source>Which node each was before edits; empty if the same</source>
            <translation>Quale nodo era ciascuno prima delle modifiche; vuoto se lo stesso</translation>
        </message>
        <message>
            <source>Which nodes are held</source>
            <translation type="vanished">Quali nodi sono tenuti</translation>
        </message>
        <message>
            <source>Young's modulus of the members, for their buckling between nodes; 0 for unknown</source>
            <translation>Modulo di Young delle aste, per la loro instabilità tra i nodi; 0 per ignoto</translation>
        </message>
    </context>
    <context>
        <name>Funicular</name>
        <message>
            <source>(The last good shape stays.)</source>
            <translation>(Resta l'ultima forma valida.)</translation>
        </message>
        <message>
            <source>, each member with {} of EA and weight</source>
            <translation>, ogni asta con {} di EA e peso</translation>
        </message>
        <message>
            <source>, with EA and weight of members times {}</source>
            <translation type="vanished">, con EA e peso delle aste per {}</translation>
        </message>
        <message>
            <source>, {} slack</source>
            <translation>, {} scariche</translation>
        </message>
        <message>
            <source>. Select another face and press “Use selected faces”.</source>
            <translation>. Scegliere un'altra faccia e premere «Facce scelte».</translation>
        </message>
        <message>
            <source>Accuracy</source>
            <translation>Precisione</translation>
        </message>
        <message>
            <source>Add load on picked nodes</source>
            <translation>Carico sui nodi scelti</translation>
        </message>
        <message>
            <source>Allow tension</source>
            <translation>Trazione</translation>
        </message>
        <message>
            <source>Along isolines</source>
            <translation>Su isolinee</translation>
        </message>
        <message>
            <source>Alternating</source>
            <translation>Alternato</translation>
        </message>
        <message>
            <source>Alternatives</source>
            <translation>Alternative</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Angolo</translation>
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it is an undo step.</source>
            <translation>Un altro comando ha chiuso il pannello di {}. Ciò che vi era stato inserito si può annullare in un passo.</translation>
        </message>
        <message>
            <source>Another command ended the panel of {}. What was entered in it was taken back.</source>
            <translation>Un altro comando ha chiuso il pannello di {}. Ciò che vi era stato inserito è stato annullato.</translation>
        </message>
        <message>
            <source>Another dialog is open in the task panel. Close it, then edit the gridshell.</source>
            <translation>Nel pannello azioni è aperto un altro dialogo. Chiuderlo, poi modificare la gridshell.</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <source>Axonometric</source>
            <translation>Assonometria</translation>
        </message>
        <message>
            <source>Back to {}</source>
            <translation>Torna a {}</translation>
        </message>
        <message>
            <source>Bar height</source>
            <translation>Altezza asta</translation>
        </message>
        <message>
            <source>Bar width</source>
            <translation>Largh. asta</translation>
        </message>
        <message>
            <source>Bars are as large as the section below.</source>
            <translation>Le barre sono grandi come la sezione più sotto.</translation>
        </message>
        <message>
            <source>Begin again from the net as it lies on its source</source>
            <translation>Ricominciare dal reticolo come sta sulla sorgente</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Bordo</translation>
        </message>
        <message>
            <source>Brick</source>
            <translation>Mattoni</translation>
        </message>
        <message>
            <source>But its panels have shrunk to {} % of their area, as where one point holds all: choose other supports</source>
            <translation>Ma i pannelli si sono ridotti al {} % della loro area, come se un punto tenesse tutto: scegliere altri vincoli</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Annulla</translation>
        </message>
        <message>
            <source>Cancelled; what was measured stays.</source>
            <translation>Annullato; ciò che è stato misurato resta.</translation>
        </message>
        <message>
            <source>Cells along u</source>
            <translation>Celle in u</translation>
        </message>
        <message>
            <source>Cells along v</source>
            <translation>Celle in v</translation>
        </message>
        <message>
            <source>Centred</source>
            <translation>Centrato</translation>
        </message>
        <message>
            <source>Choose one alternative, then restore it.</source>
            <translation>Scegliere un'alternativa, poi ripristinarla.</translation>
        </message>
        <message>
            <source>Choose one to see it, two (with Ctrl) to compare them; F2 renames. Without a choice the present form is shown.</source>
            <translation>Sceglierne una per vederla, due (con Ctrl) per confrontarle; F2 rinomina. Senza scelta si vede la forma attuale.</translation>
        </message>
        <message>
            <source>Chosen in the list: {}. Hold it in another way, soften or lift it.</source>
            <translation>Scelti nell'elenco: {}. Si può vincolare in altro modo, ammorbidire o togliere.</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Svuota</translation>
        </message>
        <message>
            <source>Click a point: the gridshell takes its accuracy and method.</source>
            <translation>Fare clic su un punto: la gridshell ne prende precisione e metodo.</translation>
        </message>
        <message>
            <source>Close the panel that is open, then click the point again.</source>
            <translation>Chiudere il pannello aperto, poi fare di nuovo clic sul punto.</translation>
        </message>
        <message>
            <source>Colour by</source>
            <translation>Colore per</translation>
        </message>
        <message>
            <source>Colours and readings</source>
            <translation>Colori e lettura</translation>
        </message>
        <message>
            <source>Compression only</source>
            <translation>Solo compressione</translation>
        </message>
        <message>
            <source>Compression only, at most {}</source>
            <translation>Solo compressione, al massimo {}</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>Angoli</translation>
        </message>
        <message>
            <source>Corners and border planes</source>
            <translation>Angoli e piani di bordo</translation>
        </message>
        <message>
            <source>Covering</source>
            <translation>Copertura</translation>
        </message>
        <message>
            <source>Crossed</source>
            <translation>Incrociato</translation>
        </message>
        <message>
            <source>Crossing</source>
            <translation>Incrocio</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>Elimina</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Profondità</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Scostamento</translation>
        </message>
        <message>
            <source>Diagonal</source>
            <translation>Diagonale</translation>
        </message>
        <message>
            <source>Diagrid</source>
            <translation>Diagrid</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Direzione</translation>
        </message>
        <message>
            <source>Displacement × {}</source>
            <translation>Spostamento × {}</translation>
        </message>
        <message>
            <source>Display</source>
            <translation>Aspetto</translation>
        </message>
        <message>
            <source>Divide curves</source>
            <translation>Dividi le curve</translation>
        </message>
        <message>
            <source>Do again what was taken back</source>
            <translation>Rifare ciò che è stato annullato</translation>
        </message>
        <message>
            <source>Do without, or end it while it goes on</source>
            <translation>Farne a meno, o interrompere mentre procede</translation>
        </message>
        <message>
            <source>Edges and vertices</source>
            <translation type="vanished">Spigoli e vertici</translation>
        </message>
        <message>
            <source>Edit gridshell</source>
            <translation>Modifica gridshell</translation>
        </message>
        <message>
            <source>Equal</source>
            <translation>Uguale</translation>
        </message>
        <message>
            <source>Equal in</source>
            <translation>Uguale in</translation>
        </message>
        <message>
            <source>Equal lengths</source>
            <translation>Lunghezze uguali</translation>
        </message>
        <message>
            <source>Esc takes nothing back: press Cancel for that, or OK to keep it.</source>
            <translation>Esc non annulla nulla: per questo premere Annulla, oppure OK per tenere tutto.</translation>
        </message>
        <message>
            <source>Every node of the border stands</source>
            <translation>Ogni nodo del bordo appoggia</translation>
        </message>
        <message>
            <source>Exaggeration</source>
            <translation>Amplificazione</translation>
        </message>
        <message>
            <source>Faces</source>
            <translation>Facce</translation>
        </message>
        <message>
            <source>Faces of {} bodies are selected: select one or more of a single body in the 3D view, then press again.</source>
            <translation>Sono scelte facce di {} corpi: sceglierne una o più di un solo corpo nella vista 3D, poi premere di nuovo.</translation>
        </message>
        <message>
            <source>Finding the shape to measure against</source>
            <translation>Ricerca della forma di riferimento</translation>
        </message>
        <message>
            <source>Fixed</source>
            <translation>Fisso</translation>
        </message>
        <message>
            <source>Fixed range</source>
            <translation>Intervallo fisso</translation>
        </message>
        <message>
            <source>Flat sheet</source>
            <translation>Foglio piano</translation>
        </message>
        <message>
            <source>Follows the expression {}</source>
            <translation>Segue l'espressione {}</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Forza</translation>
        </message>
        <message>
            <source>Force +</source>
            <translation>Forza +</translation>
        </message>
        <message>
            <source>Force {}</source>
            <translation>Forza {}</translation>
        </message>
        <message>
            <source>Force −</source>
            <translation>Forza −</translation>
        </message>
        <message>
            <source>Forget the chosen alternative</source>
            <translation>Dimenticare l'alternativa scelta</translation>
        </message>
        <message>
            <source>Free</source>
            <translation>Libero</translation>
        </message>
        <message>
            <source>From the source</source>
            <translation>Dalla sorgente</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>Fronte</translation>
        </message>
        <message>
            <source>Full lines: how far the nodes truly are from where they stand in equilibrium. Dashed lines: how far the solver says they are. Farther right is more accurate, lower is faster.</source>
            <translation>Linee piene: quanto i nodi distano davvero dall'equilibrio. Tratteggiate: quanto ne distano secondo il solutore. Più a destra è più preciso, più in basso più veloce.</translation>
        </message>
        <message>
            <source>Funicular</source>
            <translation>Funicular</translation>
        </message>
        <message>
            <source>Funicular guide</source>
            <translation>Guida di Funicular</translation>
        </message>
        <message>
            <source>Go on from the inputs of the chosen alternative</source>
            <translation>Proseguire dai dati dell'alternativa scelta</translation>
        </message>
        <message>
            <source>Gridshell</source>
            <translation>Gridshell</translation>
        </message>
        <message>
            <source>Ground, shadow</source>
            <translation>Terreno, ombra</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Altezza</translation>
        </message>
        <message>
            <source>Height {}</source>
            <translation>Altezza {}</translation>
        </message>
        <message>
            <source>Hexagon</source>
            <translation>Esagono</translation>
        </message>
        <message>
            <source>Hold it in its place</source>
            <translation type="vanished">Tiene al suo posto</translation>
        </message>
        <message>
            <source>Hold it nowhere, whatever the recipe or other supports say</source>
            <translation>Non tiene affatto, qualunque cosa dicano lo schema o altri vincoli</translation>
        </message>
        <message>
            <source>Hold it where it was laid, on the source; the green arrow raises it</source>
            <translation>Tenerlo dov'è stato posato, sulla sorgente; la freccia verde lo alza</translation>
        </message>
        <message>
            <source>How far the farthest node is from where it was laid</source>
            <translation>Quanto il nodo più lontano dista da dove era steso</translation>
        </message>
        <message>
            <source>How far the nodes are from where they were laid, on the average</source>
            <translation>Quanto i nodi distano in media da dove erano stesi</translation>
        </message>
        <message>
            <source>How stiff the chosen supports are: at the right end rigid, at the left end free</source>
            <translation>Quanto sono rigidi i vincoli scelti: a destra rigidi, a sinistra liberi</translation>
        </message>
        <message>
            <source>How the solve went, against time. Full line: distance from equilibrium, dashed: largest unbalanced force. The level line is what is asked for: below it a curve has arrived.</source>
            <translation>Andamento della soluzione nel tempo. Linea piena: distanza dall'equilibrio, tratteggiata: massima forza non equilibrata. La linea orizzontale è ciò che si chiede: sotto di essa una curva è arrivata.</translation>
        </message>
        <message>
            <source>It stands on its corners</source>
            <translation>Sta sui suoi angoli</translation>
        </message>
        <message>
            <source>It stands on its corners, and its borders stay in vertical planes</source>
            <translation>Sta sui suoi angoli, e i suoi bordi restano in piani verticali</translation>
        </message>
        <message>
            <source>It stands on its own supports alone</source>
            <translation>Sta soltanto sui propri vincoli</translation>
        </message>
        <message>
            <source>Its unit</source>
            <translation>Sua unità</translation>
        </message>
        <message>
            <source>Kagome</source>
            <translation>Kagome</translation>
        </message>
        <message>
            <source>Keep this</source>
            <translation>Conserva</translation>
        </message>
        <message>
            <source>Keep this form under a name</source>
            <translation>Conservare questa forma con un nome</translation>
        </message>
        <message>
            <source>Laid</source>
            <translation>Steso</translation>
        </message>
        <message>
            <source>Largest compression in a member</source>
            <translation>Massima compressione in un'asta</translation>
        </message>
        <message>
            <source>Largest tension in a member</source>
            <translation>Massima trazione in un'asta</translation>
        </message>
        <message>
            <source>Lay the net on the faces that are selected in the 3D view</source>
            <translation>Stendere il reticolo sulle facce scelte nella vista 3D</translation>
        </message>
        <message>
            <source>Lay the pattern</source>
            <translation>Stendi il motivo</translation>
        </message>
        <message>
            <source>Leave them out</source>
            <translation>Toglile</translation>
        </message>
        <message>
            <source>Legend</source>
            <translation>Legenda</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Lunghezza</translation>
        </message>
        <message>
            <source>Length matching</source>
            <translation>Mantenimento</translation>
        </message>
        <message>
            <source>Length matching was left out: each of its rounds is one more solve.</source>
            <translation>Il mantenimento delle lunghezze è escluso: ogni suo ciclo è una soluzione in più.</translation>
        </message>
        <message>
            <source>Length of the longest member</source>
            <translation>Lunghezza dell'asta più lunga</translation>
        </message>
        <message>
            <source>Length {}</source>
            <translation>Lunghezza {}</translation>
        </message>
        <message>
            <source>Lengths differ by {} % → {} % (rms), best reached after {} rounds</source>
            <translation>Le lunghezze differiscono del {} % → {} % (rms), il meglio dopo {} cicli</translation>
        </message>
        <message>
            <source>Lengths differ from those on the source by {} % (rms)</source>
            <translation>Le lunghezze differiscono da quelle sulla sorgente del {} % (rms)</translation>
        </message>
        <message>
            <source>Less than {} from equilibrium</source>
            <translation>Meno di {} dall'equilibrio</translation>
        </message>
        <message>
            <source>Let go of what is chosen in the list, or free the nodes that are picked</source>
            <translation>Lasciare ciò che è scelto nella lista, o liberare i nodi presi</translation>
        </message>
        <message>
            <source>Let it slide in the plane across the direction that is chosen below</source>
            <translation>Lascia scorrere nel piano perpendicolare alla direzione scelta sotto</translation>
        </message>
        <message>
            <source>Let it slide in the vertical plane of its edge or of the border</source>
            <translation>Lascia scorrere nel piano verticale del suo spigolo o del bordo</translation>
        </message>
        <message>
            <source>Let it slide on a line in the direction that is chosen below</source>
            <translation>Lascia scorrere su una linea nella direzione scelta sotto</translation>
        </message>
        <message>
            <source>Let it slide up and down</source>
            <translation>Lascia scorrere in su e in giù</translation>
        </message>
        <message>
            <source>Lift</source>
            <translation>Togli</translation>
        </message>
        <message>
            <source>Line along</source>
            <translation>Linea lungo</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linee</translation>
        </message>
        <message>
            <source>Lines and covering</source>
            <translation>Linee e copertura</translation>
        </message>
        <message>
            <source>Load {}</source>
            <translation>Carico {}</translation>
        </message>
        <message>
            <source>Longest</source>
            <translation>Più lunga</translation>
        </message>
        <message>
            <source>Lowest points</source>
            <translation>Punti più bassi</translation>
        </message>
        <message>
            <source>Match lengths</source>
            <translation>Mantieni lunghezze</translation>
        </message>
        <message>
            <source>Matching lengths, {} rounds</source>
            <translation>Mantenimento delle lunghezze, {} cicli</translation>
        </message>
        <message>
            <source>Matplotlib draws with another Qt than FreeCAD's, as some addon has asked of it: start FreeCAD again, and use Funicular before that addon.</source>
            <translation>Matplotlib disegna con un Qt diverso da quello di FreeCAD, chiesto da un altro addon: riavviare FreeCAD e usare Funicular prima di quell'addon.</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>Misura di nuovo</translation>
        </message>
        <message>
            <source>Measure the gridshell as it is now</source>
            <translation>Misurare la gridshell com'è ora</translation>
        </message>
        <message>
            <source>Measuring</source>
            <translation>Misura in corso</translation>
        </message>
        <message>
            <source>Measuring {} by {}, {} of {}</source>
            <translation>Misura di {} con {}, {} di {}</translation>
        </message>
        <message>
            <source>Member force</source>
            <translation>Forza nelle aste</translation>
        </message>
        <message>
            <source>Member length</source>
            <translation>Lunghezza delle aste</translation>
        </message>
        <message>
            <source>Member {}</source>
            <translation>Asta {}</translation>
        </message>
        <message>
            <source>Members</source>
            <translation>Aste</translation>
        </message>
        <message>
            <source>Members up to {} times as long as on the face: stiffer ones stretch less</source>
            <translation>Aste fino a {} volte più lunghe che sulla faccia: più rigide si allungano meno</translation>
        </message>
        <message>
            <source>Mesh file</source>
            <translation>File di mesh</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Metodo</translation>
        </message>
        <message>
            <source>More of the net</source>
            <translation>Altro sul reticolo</translation>
        </message>
        <message>
            <source>Most shear</source>
            <translation>Scorrimento max</translation>
        </message>
        <message>
            <source>Needs a section and the strength or Young's modulus of its material.</source>
            <translation>Serve una sezione e la resistenza o il modulo di Young del materiale.</translation>
        </message>
        <message>
            <source>Needs a section: choose its shape and size.</source>
            <translation>Serve una sezione: sceglierne forma e misure.</translation>
        </message>
        <message>
            <source>Net</source>
            <translation>Reticolo</translation>
        </message>
        <message>
            <source>Newton</source>
            <translation>Newton</translation>
        </message>
        <message>
            <source>No place for the load is selected: select nodes of the gridshell, or edges and vertices of its source, in the 3D view.</source>
            <translation>Nessun punto scelto per il carico: selezionare nodi del reticolo, o bordi e vertici della sua sorgente, nella vista 3D.</translation>
        </message>
        <message>
            <source>No tool (Esc): a click on a mark chooses its support in the list</source>
            <translation>Nessuno strumento (Esc): un clic su un segno sceglie il suo vincolo nella lista</translation>
        </message>
        <message>
            <source>Node {}</source>
            <translation>Nodo {}</translation>
        </message>
        <message>
            <source>Nodes</source>
            <translation>Nodi</translation>
        </message>
        <message>
            <source>Nodes picked: {}</source>
            <translation>Nodi presi: {}</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Nessuno</translation>
        </message>
        <message>
            <source>Nothing to build on is selected. Select a face in the 3D view, or several of one body, then run Gridshell again.</source>
            <translation>Non è scelto nulla su cui costruire. Scegliere una faccia nella vista 3D, o più facce di un corpo, poi ripetere Gridshell.</translation>
        </message>
        <message>
            <source>Off, mean</source>
            <translation>Scarto medio</translation>
        </message>
        <message>
            <source>Off, most</source>
            <translation>Scarto max</translation>
        </message>
        <message>
            <source>On a line</source>
            <translation type="vanished">Su una linea</translation>
        </message>
        <message>
            <source>On a plane</source>
            <translation type="vanished">Su un piano</translation>
        </message>
        <message>
            <source>On its vertical line</source>
            <translation type="vanished">Sulla sua linea verticale</translation>
        </message>
        <message>
            <source>On its vertical plane</source>
            <translation type="vanished">Sul suo piano verticale</translation>
        </message>
        <message>
            <source>One iteration of the solver more, then a pause</source>
            <translation>Ancora un'iterazione del solutore, poi pausa</translation>
        </message>
        <message>
            <source>Opening rims</source>
            <translation>Bordi delle aperture</translation>
        </message>
        <message>
            <source>Other diagonal</source>
            <translation>Altra diagonale</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Parametro</translation>
        </message>
        <message>
            <source>Parts of {} gridshells are selected: select nodes or members of one in the 3D view.</source>
            <translation>Sono scelte parti di {} gridshell: scegliere nodi o aste di una sola nella vista 3D.</translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation>Motivo</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Pausa</translation>
        </message>
        <message>
            <source>Paused</source>
            <translation>In pausa</translation>
        </message>
        <message>
            <source>Pick all nodes on an edge of the source: click near it</source>
            <translation>Prendere tutti i nodi su uno spigolo della sorgente: fare clic vicino</translation>
        </message>
        <message>
            <source>Pick nodes in the 3D view with one of the tools, or choose a support.</source>
            <translation>Prendere nodi nella vista 3D con uno degli strumenti, o scegliere un vincolo.</translation>
        </message>
        <message>
            <source>Pick nodes: click one, or drag a box; with Alt a lasso. Shift adds to what is picked</source>
            <translation>Prendere nodi: fare clic su uno o tirare un riquadro; con Alt un lazo. Maiusc aggiunge</translation>
        </message>
        <message>
            <source>Pick nothing</source>
            <translation>Non prendere nulla</translation>
        </message>
        <message>
            <source>Pick the nodes in a box. Shift adds to what is picked</source>
            <translation>Prendere i nodi in un riquadro. Maiusc aggiunge</translation>
        </message>
        <message>
            <source>Pick the nodes within a line drawn by hand. Shift adds to what is picked</source>
            <translation>Prendere i nodi entro una linea a mano libera. Maiusc aggiunge</translation>
        </message>
        <message>
            <source>Picked: {}, {} nodes</source>
            <translation>Presi: {}, {} nodi</translation>
        </message>
        <message>
            <source>Plan</source>
            <translation>Pianta</translation>
        </message>
        <message>
            <source>Plane across</source>
            <translation>Piano normale a</translation>
        </message>
        <message>
            <source>Point load</source>
            <translation>Carico concentrato</translation>
        </message>
        <message>
            <source>Point loads</source>
            <translation>Carichi concentrati</translation>
        </message>
        <message>
            <source>Points</source>
            <translation type="vanished">Punti</translation>
        </message>
        <message>
            <source>Properties to change: {}.</source>
            <translation>Proprietà da cambiare: {}.</translation>
        </message>
        <message>
            <source>Pure</source>
            <translation>Pura</translation>
        </message>
        <message>
            <source>Put 1 kN on each of the nodes that are picked, or on those of the edges and vertices of the source that are selected in FreeCAD</source>
            <translation>Mettere 1 kN su ciascuno dei nodi scelti, o su quelli dei bordi e vertici della sorgente selezionati in FreeCAD</translation>
        </message>
        <message>
            <source>Quad</source>
            <translation>Quadrato</translation>
        </message>
        <message>
            <source>Raise</source>
            <translation>Alza</translation>
        </message>
        <message>
            <source>Raise or lower a node: drag it along z, and the net is laid anew</source>
            <translation>Alzare o abbassare un nodo: trascinarlo lungo z, e il reticolo è steso di nuovo</translation>
        </message>
        <message>
            <source>Reaction {}</source>
            <translation>Reazione {}</translation>
        </message>
        <message>
            <source>Reactions</source>
            <translation>Reazioni</translation>
        </message>
        <message>
            <source>Recipe {}: {} nodes</source>
            <translation>Schema {}: {} nodi</translation>
        </message>
        <message>
            <source>Recipe: {}</source>
            <translation>Schema: {}</translation>
        </message>
        <message>
            <source>Rectangular</source>
            <translation>Rettangolare</translation>
        </message>
        <message>
            <source>Rectangular bars</source>
            <translation>Aste rettangolari</translation>
        </message>
        <message>
            <source>Rectangular bars and covering</source>
            <translation>Aste rettangolari e copertura</translation>
        </message>
        <message>
            <source>Redo</source>
            <translation>Ripeti</translation>
        </message>
        <message>
            <source>Relax slowly</source>
            <translation>Rilassa piano</translation>
        </message>
        <message>
            <source>Relaxation</source>
            <translation>Rilassamento</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Rimuovi</translation>
        </message>
        <message>
            <source>Reset</source>
            <translation>Ripristina</translation>
        </message>
        <message>
            <source>Restore</source>
            <translation>Ripristina</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Riprendi</translation>
        </message>
        <message>
            <source>Ribs u</source>
            <translation>Nervature u</translation>
        </message>
        <message>
            <source>Ribs v</source>
            <translation>Nervature v</translation>
        </message>
        <message>
            <source>Rigid</source>
            <translation>Rigido</translation>
        </message>
        <message>
            <source>Rise</source>
            <translation>Freccia</translation>
        </message>
        <message>
            <source>Round</source>
            <translation>Tonda</translation>
        </message>
        <message>
            <source>Round bars</source>
            <translation>Aste tonde</translation>
        </message>
        <message>
            <source>Round bars and covering</source>
            <translation>Aste tonde e copertura</translation>
        </message>
        <message>
            <source>Ruled faces</source>
            <translation>Facce rigate</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>Salva con nome…</translation>
        </message>
        <message>
            <source>Save what was measured</source>
            <translation>Salva la misura</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Sezione</translation>
        </message>
        <message>
            <source>Select a gridshell and press “What accuracy costs”.</source>
            <translation>Scegliere una gridshell e premere «Quanto costa la precisione».</translation>
        </message>
        <message>
            <source>Select either nodes of the gridshell or edges of its source, and make one support of each.</source>
            <translation>Scegliere o nodi della gridshell o spigoli della sua sorgente, e fare un vincolo di ciascuno.</translation>
        </message>
        <message>
            <source>Shared by</source>
            <translation>Ripartito per</translation>
        </message>
        <message>
            <source>Shift along u</source>
            <translation>Spostato in u</translation>
        </message>
        <message>
            <source>Shift along v</source>
            <translation>Spostato in v</translation>
        </message>
        <message>
            <source>Shorten what has become longer than on the source and lengthen what has become shorter, round by round, as far as equilibrium lets it</source>
            <translation>Accorciare ciò che è più lungo che sulla sorgente e allungare ciò che è più corto, ciclo dopo ciclo, finché l'equilibrio lo consente</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Mostra</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Lato</translation>
        </message>
        <message>
            <source>Slack</source>
            <translation>Lente</translation>
        </message>
        <message>
            <source>Slack members</source>
            <translation>Aste scariche</translation>
        </message>
        <message>
            <source>Slack members were left out of the net.</source>
            <translation>Le aste lente sono state tolte dalla rete.</translation>
        </message>
        <message>
            <source>Snow</source>
            <translation>Neve</translation>
        </message>
        <message>
            <source>Solution</source>
            <translation>Soluzione</translation>
        </message>
        <message>
            <source>Solve once more without each effect: how much time it takes, and how far the shape moves. Nothing is left out by this.</source>
            <translation>Risolvere ancora senza ciascun effetto: quanto tempo richiede e di quanto si sposta la forma. Nulla viene tolto.</translation>
        </message>
        <message>
            <source>Solving</source>
            <translation>Soluzione in corso</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Sorgente</translation>
        </message>
        <message>
            <source>Source, pale</source>
            <translation>Sorgente, pallida</translation>
        </message>
        <message>
            <source>Start (u, v)</source>
            <translation>Inizio (u, v)</translation>
        </message>
        <message>
            <source>Step along u</source>
            <translation>Passo in u</translation>
        </message>
        <message>
            <source>Step along v</source>
            <translation>Passo in v</translation>
        </message>
        <message>
            <source>Stiffness</source>
            <translation>Rigidezza</translation>
        </message>
        <message>
            <source>Stiffness EA</source>
            <translation>Rigidezza EA</translation>
        </message>
        <message>
            <source>Stop measuring; what was measured stays</source>
            <translation>Smettere di misurare; ciò che è stato misurato resta</translation>
        </message>
        <message>
            <source>Strength</source>
            <translation>Resistenza</translation>
        </message>
        <message>
            <source>Stress</source>
            <translation>Tensione</translation>
        </message>
        <message>
            <source>Stress {}</source>
            <translation>Tensione {}</translation>
        </message>
        <message>
            <source>Sun altitude</source>
            <translation>Altezza sole</translation>
        </message>
        <message>
            <source>Sun azimuth</source>
            <translation>Azimut del sole</translation>
        </message>
        <message>
            <source>Support</source>
            <translation>Vincolo</translation>
        </message>
        <message>
            <source>Supports</source>
            <translation>Vincoli</translation>
        </message>
        <message>
            <source>Table, and a picture of the same name (*.csv)</source>
            <translation>Tabella, e un'immagine con lo stesso nome (*.csv)</translation>
        </message>
        <message>
            <source>Take back the last step in this section</source>
            <translation>Annullare l'ultimo passo in questa sezione</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>Togli</translation>
        </message>
        <message>
            <source>Take them back</source>
            <translation>Rimetterle</translation>
        </message>
        <message>
            <source>Take {} away</source>
            <translation>Togliere {}</translation>
        </message>
        <message>
            <source>Ten times as stiff</source>
            <translation>Dieci volte più rigide</translation>
        </message>
        <message>
            <source>That is less than {}: it may be left out.</source>
            <translation>È meno di {}: si può togliere.</translation>
        </message>
        <message>
            <source>The direction of a line, or the normal of a plane: an axis, or a straight edge or plane face that is selected</source>
            <translation>La direzione di una linea o la normale di un piano: un asse, oppure uno spigolo retto o una faccia piana scelti</translation>
        </message>
        <message>
            <source>The gridshell has changed since this was begun: press “Measure again”.</source>
            <translation>La gridshell è cambiata da quando si è iniziato: premere «Misura di nuovo».</translation>
        </message>
        <message>
            <source>The gridshell has no Net any more.</source>
            <translation>Il reticolo non ha più una rete.</translation>
        </message>
        <message>
            <source>The guide is missing: {}. Install the addon again.</source>
            <translation>Manca la guida: {}. Reinstallare l'addon.</translation>
        </message>
        <message>
            <source>The longest arrow is {}, at node {}.</source>
            <translation>La freccia più lunga è {}, al nodo {}.</translation>
        </message>
        <message>
            <source>The lowest nodes stand</source>
            <translation>I nodi più bassi appoggiano</translation>
        </message>
        <message>
            <source>The members cannot carry these loads.</source>
            <translation>Le aste non possono portare questi carichi.</translation>
        </message>
        <message>
            <source>The rims of openings stand</source>
            <translation>I bordi delle aperture appoggiano</translation>
        </message>
        <message>
            <source>The way from the source is drawn {} times as long. Figures are the true ones.</source>
            <translation>La distanza dalla sorgente è disegnata {} volte più lunga. Le cifre sono quelle vere.</translation>
        </message>
        <message>
            <source>There are no reactions yet.</source>
            <translation>Non ci sono ancora reazioni.</translation>
        </message>
        <message>
            <source>These steps make about {} nodes: press Enter to lay them, or give longer ones</source>
            <translation>Questi passi danno circa {} nodi: premere Invio per posarli, o darne di più lunghi</translation>
        </message>
        <message>
            <source>Together these may move it by {}: leave out one, then measure again.</source>
            <translation>Insieme possono spostarla di {}: toglierne uno, poi misurare di nuovo.</translation>
        </message>
        <message>
            <source>Triangle</source>
            <translation>Triangolo</translation>
        </message>
        <message>
            <source>Triangles</source>
            <translation>Triangoli</translation>
        </message>
        <message>
            <source>Turn the view, and let it hold the whole net: {}</source>
            <translation>Girare la vista perché contenga tutto il reticolo: {}</translation>
        </message>
        <message>
            <source>Turned</source>
            <translation>Ruotato</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>Annulla</translation>
        </message>
        <message>
            <source>Undo and redo end the panel of {}: its inputs no longer hold.</source>
            <translation>Annulla e Ripeti chiudono il pannello di {}: i suoi dati non valgono più.</translation>
        </message>
        <message>
            <source>Undo matching</source>
            <translation>Non mantenere</translation>
        </message>
        <message>
            <source>Upright line</source>
            <translation>Linea verticale</translation>
        </message>
        <message>
            <source>Upright plane</source>
            <translation>Piano verticale</translation>
        </message>
        <message>
            <source>Use selected faces</source>
            <translation>Facce scelte</translation>
        </message>
        <message>
            <source>Utilisation</source>
            <translation>Sfruttamento</translation>
        </message>
        <message>
            <source>Utilisation {}</source>
            <translation>Sfruttamento {}</translation>
        </message>
        <message>
            <source>Variant {}</source>
            <translation>Variante {}</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Vista</translation>
        </message>
        <message>
            <source>Voronoi</source>
            <translation>Voronoi</translation>
        </message>
        <message>
            <source>Wait until the form has settled, then keep it.</source>
            <translation>Aspettare che la forma si fermi, poi conservarla.</translation>
        </message>
        <message>
            <source>Watch how the net comes to hang by the relaxation of Brivio et al. (2009), step by step, instead of the fast solver. What it comes to is the same.</source>
            <translation>Guardare come il reticolo si appende col rilassamento di Brivio et al. (2009), passo per passo, invece del solutore veloce. Il risultato è lo stesso.</translation>
        </message>
        <message>
            <source>Weight</source>
            <translation>Peso</translation>
        </message>
        <message>
            <source>Weights</source>
            <translation>Pesi</translation>
        </message>
        <message>
            <source>Weld within</source>
            <translation>Salda entro</translation>
        </message>
        <message>
            <source>What a solve to this accuracy takes, as predicted. Below it the largest step that brings the net as near to the smooth surface that it stands for, which is no error where members are the straight beams that will be built.</source>
            <translation>Quanto richiede, secondo la previsione, una soluzione con questa precisione. Sotto, il passo più grande che porta il reticolo altrettanto vicino alla superficie liscia che rappresenta; non è un errore dove le aste sono le travi diritte da costruire.</translation>
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation>Quanto costa la precisione</translation>
        </message>
        <message>
            <source>What accuracy costs: {}</source>
            <translation>Quanto costa la precisione: {}</translation>
        </message>
        <message>
            <source>What effects cost</source>
            <translation>Quanto costano gli effetti</translation>
        </message>
        <message>
            <source>What is chosen here is ringed in the 3D view, and changed below</source>
            <translation>Ciò che è scelto qui è cerchiato nella vista 3D, e si cambia sotto</translation>
        </message>
        <message>
            <source>What is selected is curved and has no one direction: select a straight edge or a plane face.</source>
            <translation>Ciò che è scelto è curvo e non ha una sola direzione: scegliere uno spigolo retto o una faccia piana.</translation>
        </message>
        <message>
            <source>Where the force points to</source>
            <translation>Dove punta la forza</translation>
        </message>
        <message>
            <source>Whether it stands in compression only</source>
            <translation>Se sta in sola compressione</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Larghezza</translation>
        </message>
        <message>
            <source>Within {} of the smooth form: step {}, {}</source>
            <translation>A meno di {} dalla forma liscia: passo {}, {}</translation>
        </message>
        <message>
            <source>Without it {}, and the shape moves by {}.</source>
            <translation>Senza di esso {}, e la forma si sposta di {}.</translation>
        </message>
        <message>
            <source>Write what was measured as a table (.csv) and a picture (.png)</source>
            <translation>Scrivere ciò che è stato misurato come tabella (.csv) e immagine (.png)</translation>
        </message>
        <message>
            <source>Young's modulus</source>
            <translation>Modulo E</translation>
        </message>
        <message>
            <source>Zigzag</source>
            <translation>Zigzag</translation>
        </message>
        <message>
            <source>a recipe for all nodes that no support speaks of</source>
            <translation>uno schema per tutti i nodi di cui nessun vincolo parla</translation>
        </message>
        <message>
            <source>about {}</source>
            <translation>circa {}</translation>
        </message>
        <message>
            <source>accuracy now: {}</source>
            <translation>precisione attuale: {}</translation>
        </message>
        <message>
            <source>against x</source>
            <translation>contro x</translation>
        </message>
        <message>
            <source>against y</source>
            <translation>contro y</translation>
        </message>
        <message>
            <source>along x</source>
            <translation>lungo x</translation>
        </message>
        <message>
            <source>along y</source>
            <translation>lungo y</translation>
        </message>
        <message>
            <source>asked for: {}</source>
            <translation>richiesto: {}</translation>
        </message>
        <message>
            <source>borne</source>
            <translation>portata</translation>
        </message>
        <message>
            <source>borne (own scale)</source>
            <translation>portata (scala propria)</translation>
        </message>
        <message>
            <source>by buckling</source>
            <translation>per instabilità</translation>
        </message>
        <message>
            <source>by step</source>
            <translation>dal passo</translation>
        </message>
        <message>
            <source>cancelled</source>
            <translation>annullato</translation>
        </message>
        <message>
            <source>carries</source>
            <translation>porta</translation>
        </message>
        <message>
            <source>change</source>
            <translation>differenza</translation>
        </message>
        <message>
            <source>compression</source>
            <translation>compressione</translation>
        </message>
        <message>
            <source>compression −</source>
            <translation>compressione −</translation>
        </message>
        <message>
            <source>compression − (own scale)</source>
            <translation>compressione − (scala propria)</translation>
        </message>
        <message>
            <source>distance from equilibrium</source>
            <translation>distanza dall'equilibrio</translation>
        </message>
        <message>
            <source>down</source>
            <translation>in basso</translation>
        </message>
        <message>
            <source>fixed</source>
            <translation>fisso</translation>
        </message>
        <message>
            <source>free</source>
            <translation>libero</translation>
        </message>
        <message>
            <source>from</source>
            <translation>da</translation>
        </message>
        <message>
            <source>no</source>
            <translation>no</translation>
        </message>
        <message>
            <source>off</source>
            <translation>no</translation>
        </message>
        <message>
            <source>on a line</source>
            <translation>su una linea</translation>
        </message>
        <message>
            <source>on a plane</source>
            <translation>su un piano</translation>
        </message>
        <message>
            <source>on its vertical line</source>
            <translation>sulla sua linea verticale</translation>
        </message>
        <message>
            <source>on its vertical plane</source>
            <translation>sul suo piano verticale</translation>
        </message>
        <message>
            <source>point loads</source>
            <translation>carichi concentrati</translation>
        </message>
        <message>
            <source>present</source>
            <translation>attuale</translation>
        </message>
        <message>
            <source>range is fixed</source>
            <translation>intervallo fisso</translation>
        </message>
        <message>
            <source>residual {:.0e}</source>
            <translation>residuo {:.0e}</translation>
        </message>
        <message>
            <source>rigid</source>
            <translation>rigido</translation>
        </message>
        <message>
            <source>selected edge or face</source>
            <translation>spigolo o faccia scelti</translation>
        </message>
        <message>
            <source>slack</source>
            <translation>scarica</translation>
        </message>
        <message>
            <source>slack, carries nothing</source>
            <translation>scarica, non porta nulla</translation>
        </message>
        <message>
            <source>snow</source>
            <translation>neve</translation>
        </message>
        <message>
            <source>tension</source>
            <translation>trazione</translation>
        </message>
        <message>
            <source>tension +</source>
            <translation>trazione +</translation>
        </message>
        <message>
            <source>tension + (own scale)</source>
            <translation>trazione + (scala propria)</translation>
        </message>
        <message>
            <source>the covering</source>
            <translation>copertura</translation>
        </message>
        <message>
            <source>the members' stiffness</source>
            <translation>rigidezza delle aste</translation>
        </message>
        <message>
            <source>the members' weight</source>
            <translation>peso delle aste</translation>
        </message>
        <message>
            <source>the solve was cancelled and the last good shape stays; recompute to solve again</source>
            <translation>la soluzione è stata annullata e resta l'ultima forma valida; ricalcolare per risolvere di nuovo</translation>
        </message>
        <message>
            <source>time in the solver</source>
            <translation>tempo nel solutore</translation>
        </message>
        <message>
            <source>to</source>
            <translation>a</translation>
        </message>
        <message>
            <source>too much</source>
            <translation>troppo</translation>
        </message>
        <message>
            <source>too much (own scale)</source>
            <translation>troppo (scala propria)</translation>
        </message>
        <message>
            <source>up</source>
            <translation>in alto</translation>
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
            <translation>sì</translation>
        </message>
        <message>
            <source>z, upright</source>
            <translation>z, verticale</translation>
        </message>
        <message>
            <source>{} % faster</source>
            <translation>{} % più veloce</translation>
        </message>
        <message>
            <source>{} % slower</source>
            <translation>{} % più lento</translation>
        </message>
        <message>
            <source>{} Accuracy and method are as before.</source>
            <translation>{} Precisione e metodo sono come prima.</translation>
        </message>
        <message>
            <source>{} and {} are written.</source>
            <translation>{} e {} sono scritti.</translation>
        </message>
        <message>
            <source>{} bodies or nets are selected, and a gridshell stands on one. Select faces of a single body in the 3D view, then run Gridshell again.</source>
            <translation>Sono scelti {} corpi o reticoli, e una gridshell sta su uno. Scegliere facce di un solo corpo nella vista 3D, poi ripetere Gridshell.</translation>
        </message>
        <message>
            <source>{} by {}: {}, truly {}</source>
            <translation>{} con {}: {}, in realtà {}</translation>
        </message>
        <message>
            <source>{} downward</source>
            <translation>{} verso il basso</translation>
        </message>
        <message>
            <source>{} edges and faces are selected: select one, in the model or the 3D view.</source>
            <translation>Sono scelti {} spigoli e facce: sceglierne uno, nel modello o nella vista 3D.</translation>
        </message>
        <message>
            <source>{} follows the expression {}: change that instead.</source>
            <translation>{} segue l'espressione {}: cambiare quella.</translation>
        </message>
        <message>
            <source>{} from equilibrium</source>
            <translation>{} dall'equilibrio</translation>
        </message>
        <message>
            <source>{} from the source</source>
            <translation>{} dalla sorgente</translation>
        </message>
        <message>
            <source>{} gave up after {}, without coming as near as {}.</source>
            <translation>{} ha rinunciato dopo {}, senza arrivare a {}.</translation>
        </message>
        <message>
            <source>{} gridshells are selected, and this is done for one. Select a single Gridshell in the tree, then run the command again.</source>
            <translation>Sono scelte {} gridshell, e questo si fa per una. Sceglierne una sola nell'albero, poi ripetere il comando.</translation>
        </message>
        <message>
            <source>{} has another net: restore it to see it.</source>
            <translation>{} ha un altro reticolo: ripristinarla per vederla.</translation>
        </message>
        <message>
            <source>{} is selected as a whole, with {} faces: select those that the gridshell shall follow, in the 3D view.</source>
            <translation>{} è scelto per intero, con {} facce: scegliere nella vista 3D quelle che la gridshell deve seguire.</translation>
        </message>
        <message>
            <source>{} is shown, as it was kept. Esc shows the present form again.</source>
            <translation>Si vede {}, com'era stata tenuta. Esc mostra di nuovo la forma attuale.</translation>
        </message>
        <message>
            <source>{} is there already. Replace it?</source>
            <translation>{} esiste già. Sostituire?</translation>
        </message>
        <message>
            <source>{} members are in tension.</source>
            <translation>{} aste sono in trazione.</translation>
        </message>
        <message>
            <source>{} members are slack: they carry nothing.</source>
            <translation>{} aste sono scariche: non portano nulla.</translation>
        </message>
        <message>
            <source>{} of {} is not what the net lies on: select edges of its source.</source>
            <translation>{} di {} non è ciò su cui sta il reticolo: scegliere spigoli della sua sorgente.</translation>
        </message>
        <message>
            <source>{} of {} measured</source>
            <translation>{} di {} misurati</translation>
        </message>
        <message>
            <source>{} of {} members in tension, at most {}</source>
            <translation>{} aste su {} in trazione, al massimo {}</translation>
        </message>
        <message>
            <source>{} overall: step {}, {}</source>
            <translation type="vanished">{} in tutto: passo {}, {}</translation>
        </message>
        <message>
            <source>{} sideways</source>
            <translation>{} di lato</translation>
        </message>
        <message>
            <source>{} supports pull the shell down, so it pulls upward there.</source>
            <translation>{} vincoli tirano la gridshell in basso: lì essa tira verso l'alto.</translation>
        </message>
        <message>
            <source>{} total, balanced to {:.0e}</source>
            <translation>{} in tutto, in equilibrio a meno di {:.0e}</translation>
        </message>
        <message>
            <source>{} upward</source>
            <translation>{} verso l'alto</translation>
        </message>
        <message>
            <source>{}, at {}</source>
            <translation>{}, a {}</translation>
        </message>
        <message>
            <source>{}, {} iterations</source>
            <translation>{}, {} iterazioni</translation>
        </message>
        <message>
            <source>{}, {} node</source>
            <translation>{}, {} nodo</translation>
        </message>
        <message>
            <source>{}, {} nodes</source>
            <translation>{}, {} nodi</translation>
        </message>
        <message>
            <source>{}. Chosen: the gridshell was solved again in {}.</source>
            <translation>{}. Scelto: la gridshell è stata risolta di nuovo in {}.</translation>
        </message>
        <message>
            <source>{}. The gridshell has this accuracy and method.</source>
            <translation>{}. La gridshell ha questa precisione e questo metodo.</translation>
        </message>
        <message>
            <source>{}: {} %, Esc cancels</source>
            <translation>{}: {} %, Esc annulla</translation>
        </message>
        <message>
            <source>{}: {}, {} % of the time, {} calls, {} kB.</source>
            <translation>{}: {}, {} % del tempo, {} chiamate, {} kB.</translation>
        </message>
        <message>
            <source>{}: {}, {} nodes</source>
            <translation>{}: {}, {} nodi</translation>
        </message>
        <message>
            <source>“{}” is negative: give more than zero.</source>
            <translation>«{}» è negativo: dare più di zero.</translation>
        </message>
        <message>
            <source>“{}” is not a value in {}. Write for example “12 {}”.</source>
            <translation>«{}» non è un valore in {}. Scrivere per esempio «12 {}».</translation>
        </message>
    </context>
    <context>
        <name>FunicularPreferences</name>
        <message>
            <source>&amp;Accuracy</source>
            <translation>&amp;Precisione</translation>
        </message>
        <message>
            <source>&amp;Colours of forces</source>
            <translation>&amp;Colori delle forze</translation>
        </message>
        <message>
            <source>&amp;Time for a frame</source>
            <translation>&amp;Tempo per immagine</translation>
        </message>
        <message>
            <source>As the unit schema (N and kN, or lbf and kip)</source>
            <translation>Come il sistema di unità (N e kN, o lbf e kip)</translation>
        </message>
        <message>
            <source>Blue for compression, orange for tension</source>
            <translation>Blu per la compressione, arancio per la trazione</translation>
        </message>
        <message>
            <source>From one frame to the next while a form moves; more leaves more of the processor to the solver. Counts from the next time that a panel opens.</source>
            <translation>Da un'immagine alla successiva mentre una forma si muove; di più lascia al solutore più processore. Vale dalla prossima apertura di un pannello.</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Generale</translation>
        </message>
        <message>
            <source>How far from equilibrium the nodes of a new gridshell may lie</source>
            <translation>Quanto i nodi di una nuova gridshell possono distare dall'equilibrio</translation>
        </message>
        <message>
            <source>New gridshells</source>
            <translation>Nuove gridshell</translation>
        </message>
        <message>
            <source>Numbers and colours</source>
            <translation>Numeri e colori</translation>
        </message>
        <message>
            <source>One ramp, from dark to light</source>
            <translation>Una scala sola, da scuro a chiaro</translation>
        </message>
        <message>
            <source>Panel of a gridshell</source>
            <translation>Pannello di una gridshell</translation>
        </message>
        <message>
            <source>Show the form as it &amp;moves</source>
            <translation>&amp;Mostra la forma in movimento</translation>
        </message>
        <message>
            <source>Show the form on its way, at an even pace. Without it each form is shown where it comes to.</source>
            <translation>Mostrare la forma lungo il suo cammino, a ritmo costante. Altrimenti ogni forma appare dove arriva.</translation>
        </message>
        <message>
            <source>The colours of the members in the 3D view. Both are told apart with any colour vision.</source>
            <translation>I colori delle aste nella vista 3D. Entrambi si distinguono con ogni visione dei colori.</translation>
        </message>
        <message>
            <source>The unit that forces are written in: in sentences, in the legend and in the panel</source>
            <translation>L'unità in cui si scrivono le forze: nelle frasi, nella legenda e nel pannello</translation>
        </message>
        <message>
            <source>Unit of &amp;force</source>
            <translation>&amp;Unità di forza</translation>
        </message>
    </context>
    <context>
        <name>Funicular_AccuracyStudy</name>
        <message>
            <source>A plot grows beside the 3D view, and nothing waits for it. Click a point of it, and the gridshell takes that accuracy and method.</source>
            <translation>Accanto alla vista 3D cresce un grafico, e nulla lo aspetta. Con un clic su un suo punto la gridshell ne prende precisione e metodo.</translation>
        </message>
        <message>
            <source>Measure how long the selected gridshell takes at several accuracies, and choose one.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation>Misurare quanto tempo richiede la gridshell scelta con varie precisioni, e sceglierne una.
Scegliere una gridshell nell'albero o nella vista 3D, poi eseguire questo comando.</translation>
        </message>
        <message>
            <source>What accuracy costs</source>
            <translation>Quanto costa la precisione</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Covering</name>
        <message>
            <source>Cover the panels of the selected gridshell with faces.
Select one Gridshell in the tree or in the 3D view, then run this command.</source>
            <translation>Coprire con facce i pannelli della gridshell scelta.
Scegliere una gridshell nell'albero o nella vista 3D, poi eseguire questo comando.</translation>
        </message>
        <message>
            <source>Covering</source>
            <translation>Copertura</translation>
        </message>
        <message>
            <source>Each panel becomes a face that other commands of FreeCAD can use and that STEP files take. The Covering says which panels are warped and by how much, and follows the gridshell.</source>
            <translation>Ogni pannello diventa una faccia che gli altri comandi di FreeCAD e i file STEP accettano. La copertura dice quali pannelli sono svergolati e di quanto, e segue la gridshell.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Gridshell</name>
        <message>
            <source>A net is laid on the face and relaxed until each member is compressed. The panel that opens has its steps, weights and supports. Shape and numbers follow the face from then on.</source>
            <translation>Sulla faccia è steso un reticolo, rilassato finché ogni asta è compressa. Il pannello che si apre ne ha passi, pesi e vincoli. Forma e numeri seguono poi la faccia.</translation>
        </message>
        <message>
            <source>Gridshell</source>
            <translation>Gridshell</translation>
        </message>
        <message>
            <source>Turn the selected face into a compression-only gridshell.
Select a face in the 3D view, several of one body, or a Net in the tree, then run this command.</source>
            <translation>Fare della faccia scelta una gridshell in sola compressione.
Scegliere una faccia nella vista 3D, più facce di un corpo, o un reticolo nell'albero, poi eseguire questo comando.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Guide</name>
        <message>
            <source>Funicular guide</source>
            <translation>Guida di Funicular</translation>
        </message>
        <message>
            <source>The guide opens in a window of its own and needs no network.</source>
            <translation>La guida si apre in una finestra propria e non richiede la rete. È in inglese.</translation>
        </message>
        <message>
            <source>Two pages with pictures: from a face to a gridshell and out.</source>
            <translation>Due pagine con immagini: dalla faccia alla gridshell, e oltre.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_PointLoad</name>
        <message>
            <source>Point load</source>
            <translation>Carico concentrato</translation>
        </message>
        <message>
            <source>Put a load of 1 kN on each of the selected nodes.
Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.</source>
            <translation>Mettere un carico di 1 kN su ciascuno dei nodi selezionati.
Selezionare un reticolo e con esso suoi nodi, o bordi e vertici della sua sorgente.</translation>
        </message>
        <message>
            <source>The load is an object of its own below the Gridshell, with Force and Direction as properties, and keeps its place on the face, whatever the step. The shell is relaxed with it.</source>
            <translation>Il carico è un oggetto a sé sotto il reticolo, con Force e Direction come proprietà, e mantiene il suo posto sulla faccia, qualunque sia il passo. La forma viene trovata con esso.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Raise</name>
        <message>
            <source>Raise</source>
            <translation>Alza</translation>
        </message>
        <message>
            <source>Raise the selected nodes of the net by a quarter of a member, and again for more.
Select nodes of a Gridshell. The height of each is in the property Raised of its Net.</source>
            <translation>Alzare i nodi scelti del reticolo di un quarto d'asta, e di nuovo per di più.
Scegliere nodi di una gridshell. L'altezza di ciascuno sta nella proprietà Raised del suo reticolo.</translation>
        </message>
        <message>
            <source>The gridshell is relaxed again on the net that was changed. Undo takes it back.</source>
            <translation>La gridshell è rilassata di nuovo sul reticolo cambiato. Annulla riporta com'era.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Sheet</name>
        <message>
            <source>Flat sheet</source>
            <translation>Foglio piano</translation>
        </message>
        <message>
            <source>Start from a flat sheet of given size, which rises between its four corners.
Nothing needs to be selected.</source>
            <translation>Partire da un foglio piano di misura data, che si alza tra i suoi quattro angoli.
Non occorre scegliere nulla.</translation>
        </message>
        <message>
            <source>The sheet stands on its four corners and rises between them. The panel that opens has its width, its depth and all else that a gridshell has.</source>
            <translation>Il foglio sta sui suoi quattro angoli e si alza tra di essi. Il pannello che si apre ne ha larghezza, profondità e tutto ciò che ha una gridshell.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_Support</name>
        <message>
            <source>Hold the selected gridshell at its border, or where edges and vertices are selected too.
Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.</source>
            <translation>Tenere la gridshell scelta al suo bordo, o dove sono scelti anche spigoli e vertici.
Scegliere una gridshell, e con essa suoi nodi o spigoli e vertici della sua sorgente.</translation>
        </message>
        <message>
            <source>Support</source>
            <translation>Vincolo</translation>
        </message>
        <message>
            <source>The new Support stands in the tree, and its properties say how it holds its nodes: fixed, sliding in a plane or on a line, yielding, or not at all. It outlives other steps of the net.</source>
            <translation>Il nuovo vincolo sta nell'albero, e le sue proprietà dicono come tiene i suoi nodi: fissi, scorrevoli in un piano o su una linea, cedevoli, o per nulla. Resiste ad altri passi del reticolo.</translation>
        </message>
    </context>
    <context>
        <name>Funicular_TakeOut</name>
        <message>
            <source>Take out</source>
            <translation>Togli</translation>
        </message>
        <message>
            <source>Take the selected members out of the net, or the panels whose faces are selected.
Select members of a Gridshell, or faces of its Covering. Their place on the face is kept.</source>
            <translation>Togliere dal reticolo le aste scelte, o i pannelli di cui sono scelte le facce.
Scegliere aste di una gridshell, o facce della sua copertura. Il loro posto sulla faccia è conservato.</translation>
        </message>
        <message>
            <source>The covering of an opening stands on its rim. The gridshell is relaxed again. Undo takes it back.</source>
            <translation>La copertura di un'apertura sta sul suo bordo. La gridshell è rilassata di nuovo. Annulla riporta com'era.</translation>
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
            <translation>Fare di una superficie una gridshell in sola compressione</translation>
        </message>
    </context>
</TS>
