<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>Core</name>
    <message>
        <source>This could be %1; choose it, or draw on.</source>
        <translation>Lesbar als %1; auswählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>This is the mirror plane already.</source>
        <translation>Das ist schon die Spiegelebene.</translation>
    </message>
    <message>
        <source>There is no mirror plane.</source>
        <translation>Es gibt keine Spiegelebene.</translation>
    </message>
    <message>
        <source>The mirror image would hang in the air; move the mirror plane, or drop it.</source>
        <translation>Das Spiegelbild hinge in der Luft; die Spiegelebene verschieben oder aufheben.</translation>
    </message>
    <message>
        <source>All but this corner fits %1; it is %2 from where it would be.</source>
        <translation>Bis auf diese Ecke lesbar als %1; sie liegt %2 daneben.</translation>
    </message>
    <message>
        <source>This is too small to be read: it is %1 px across. Zoom in and draw it larger.</source>
        <translation>Zu klein zum Lesen: %1 px groß. Bitte hineinzoomen und größer zeichnen.</translation>
    </message>
    <message>
        <source>These lines converge as in perspective, by up to %1 degrees. Only right-angled shapes are read so; draw edges that are parallel in space as parallel lines.</source>
        <translation>Diese Linien laufen wie in einer Perspektive zusammen, um bis zu %1 Grad. Nur rechtwinklige Formen werden so gelesen; im Raum parallele Kanten bitte als parallele Linien zeichnen.</translation>
    </message>
    <message>
        <source>This line is a curve; solids are drawn with straight lines (round them afterwards).</source>
        <translation>Diese Linie ist krumm; Körper werden mit geraden Linien gezeichnet (gerundet werden sie danach).</translation>
    </message>
    <message>
        <source>One line is missing here; with it this is %1.</source>
        <translation>Hier fehlt eine Linie; mit ihr lesbar als %1.</translation>
    </message>
    <message>
        <source>Without this line this is %1; edges that cannot be seen from here are not drawn.</source>
        <translation>Ohne diese Linie lesbar als %1; Kanten, die man von hier nicht sieht, werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Without these lines this is %1; edges that cannot be seen from here are not drawn.</source>
        <translation>Ohne diese Linien lesbar als %1; Kanten, die man von hier nicht sieht, werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Without this line this is %1.</source>
        <translation>Ohne diese Linie lesbar als %1.</translation>
    </message>
    <message>
        <source>Without these lines this is %1.</source>
        <translation>Ohne diese Linien lesbar als %1.</translation>
    </message>
    <message>
        <source>Move this corner</source>
        <translation>Diese Ecke verschieben</translation>
    </message>
    <message>
        <source>Draw it straight</source>
        <translation>Gerade zeichnen</translation>
    </message>
    <message>
        <source>Draw the missing line</source>
        <translation>Die fehlende Linie zeichnen</translation>
    </message>
    <message>
        <source>Drop these lines</source>
        <translation>Diese Linien weglassen</translation>
    </message>
    <message>
        <source>%1 out of place</source>
        <translation>%1 daneben</translation>
    </message>
    <message>
        <source>cannot be seen</source>
        <translation>ist nicht zu sehen</translation>
    </message>
    <message>
        <source>is no edge</source>
        <translation>ist keine Kante</translation>
    </message>
    <message>
        <source>No face is seen there.</source>
        <translation>Dort ist keine Fläche zu sehen.</translation>
    </message>
    <message>
        <source>No closed outline runs round this place.</source>
        <translation>Um diese Stelle läuft kein geschlossener Umriss.</translation>
    </message>
    <message>
        <source>This closed line is no circle on the face; draw it straighter, or rounder.</source>
        <translation>Diese geschlossene Linie ist kein Kreis auf der Fläche; bitte gerader oder runder zeichnen.</translation>
    </message>
    <message>
        <source>This outline encloses nothing.</source>
        <translation>Dieser Umriss umschließt nichts.</translation>
    </message>
    <message>
        <source>This outline leaves the face; an outline to pull lies in one face.</source>
        <translation>Dieser Umriss verlässt die Fläche; ein Umriss zum Ziehen liegt in einer Fläche.</translation>
    </message>
    <message>
        <source>This outline says where, not how deep; pull it (L), or draw one line into the solid or out of it.</source>
        <translation>Dieser Umriss sagt, wo, aber nicht, wie tief; bitte ziehen (L) oder eine Linie in den Körper hinein oder heraus zeichnen.</translation>
    </message>
    <message>
        <source>A line that cuts a solid runs from one side of it to the other; this one ends inside a face.</source>
        <translation>Eine Linie, die einen Körper schneidet, läuft von einer Seite zur anderen; diese endet in einer Fläche.</translation>
    </message>
    <message>
        <source>The line lies in no plane, and a cut is plane; draw it straight on every face.</source>
        <translation>Die Linie liegt in keiner Ebene, und ein Schnitt ist eben; bitte auf jeder Fläche gerade zeichnen.</translation>
    </message>
    <message>
        <source>The line runs over no solid.</source>
        <translation>Die Linie läuft über keinen Körper.</translation>
    </message>
    <message>
        <source>The plane through this line misses the solid.</source>
        <translation>Die Ebene durch diese Linie verfehlt den Körper.</translation>
    </message>
    <message>
        <source>There is no solid to cut in two.</source>
        <translation>Es gibt keinen Körper, der sich teilen ließe.</translation>
    </message>
    <message>
        <source>This line could cut the solid in two; choose it, or draw on.</source>
        <translation>Diese Linie könnte den Körper teilen; bitte wählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>Cut the solid in two</source>
        <translation>Den Körper teilen</translation>
    </message>
    <message>
        <source>Cut in two</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>square</source>
        <translation>rechtwinklig</translation>
    </message>
    <message>
        <source>The solid has no such face to pull.</source>
        <translation>Der Körper hat keine solche Fläche zum Ziehen.</translation>
    </message>
    <message>
        <source>A face cannot be pulled so far.</source>
        <translation>So weit lässt sich eine Fläche nicht ziehen.</translation>
    </message>
    <message>
        <source>A pull by 0 mm changes nothing.</source>
        <translation>Ein Zug um 0 mm ändert nichts.</translation>
    </message>
    <message>
        <source>This face is not flat enough to be pulled: its corners lie in one plane to the eye only.</source>
        <translation>Diese Fläche ist zum Ziehen nicht eben genug: ihre Ecken liegen nur für das Auge in einer Ebene.</translation>
    </message>
    <message>
        <source>The faces beside this one do not tell where its corners would go; pull it with straight walls.</source>
        <translation>Die Nachbarflächen sagen nicht, wohin die Ecken dieser Fläche gingen; bitte mit geraden Wänden ziehen.</translation>
    </message>
    <message>
        <source>The face would shrink to nothing after %1; pull it less far, or with straight walls.</source>
        <translation>Die Fläche schrumpft nach %1 zu nichts; bitte weniger weit oder mit geraden Wänden ziehen.</translation>
    </message>
    <message>
        <source>A solid can be moved by numbers only.</source>
        <translation>Ein Körper lässt sich nur um Zahlen bewegen.</translation>
    </message>
    <message>
        <source>A solid cannot be scaled to nothing.</source>
        <translation>Ein Körper lässt sich nicht auf nichts verkleinern.</translation>
    </message>
    <message>
        <source>A solid is scaled by numbers from 0.000001 to 1000000.</source>
        <translation>Ein Körper wird mit Zahlen von 0,000001 bis 1000000 skaliert.</translation>
    </message>
    <message>
        <source>A solid is turned by a number of degrees.</source>
        <translation>Ein Körper wird um eine Zahl von Grad gedreht.</translation>
    </message>
    <message>
        <source>The axis to turn about has no direction.</source>
        <translation>Die Drehachse hat keine Richtung.</translation>
    </message>
    <message>
        <source>The mirror plane has no direction.</source>
        <translation>Die Spiegelebene hat keine Richtung.</translation>
    </message>
    <message>
        <source>A solid cannot be moved so far.</source>
        <translation>So weit lässt sich ein Körper nicht bewegen.</translation>
    </message>
    <message>
        <source>A name is one line of at most %1 bytes.</source>
        <translation>Ein Name ist eine Zeile von höchstens %1 Byte.</translation>
    </message>
    <message>
        <source>There is no solid called %1.</source>
        <translation>Es gibt keinen Körper namens %1.</translation>
    </message>
    <message>
        <source>There is no solid number %1; there are %2, counted from 0.</source>
        <translation>Es gibt keinen Körper Nummer %1; es sind %2, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>All solids are hidden.</source>
        <translation>Alle Körper sind ausgeblendet.</translation>
    </message>
    <message>
        <source>All solids are hidden; show one to export it.</source>
        <translation>Alle Körper sind ausgeblendet; zum Exportieren bitte einen einblenden.</translation>
    </message>
    <message>
        <source>Another solid is called %1.</source>
        <translation>Ein anderer Körper heißt schon %1.</translation>
    </message>
    <message>
        <source>The solid is shown already.</source>
        <translation>Der Körper ist schon eingeblendet.</translation>
    </message>
    <message>
        <source>The solid is hidden already.</source>
        <translation>Der Körper ist schon ausgeblendet.</translation>
    </message>
    <message>
        <source>A solid is combined with another one.</source>
        <translation>Ein Körper wird mit einem anderen verbunden.</translation>
    </message>
    <message>
        <source>The two solids do not touch each other.</source>
        <translation>Die beiden Körper berühren einander nicht.</translation>
    </message>
    <message>
        <source>A line ends %1 from what it should meet (the distance threshold is %2).</source>
        <translation>Eine Linie endet %1 vor dem, was sie treffen sollte (die Abstandsschwelle ist %2).</translation>
    </message>
    <message>
        <source>%1 line ends meet nothing; the nearest gap is %2 (the distance threshold is %3).</source>
        <translation>%1 Linienenden treffen nichts; die kleinste Lücke ist %2 (die Abstandsschwelle ist %3).</translation>
    </message>
    <message>
        <source>The lines enclose nothing: a solid needs closed outlines.</source>
        <translation>Die Linien schließen nichts ein: Ein Körper braucht geschlossene Umrisse.</translation>
    </message>
    <message>
        <source>This is a curve; solids are drawn with straight lines (round them afterwards).</source>
        <translation>Das ist eine Kurve; Körper werden mit geraden Linien gezeichnet (und danach gerundet).</translation>
    </message>
    <message>
        <source>This looks like a scribble; no straight lines were found in it.</source>
        <translation>Das sieht nach Gekritzel aus; gerade Linien wurden darin nicht gefunden.</translation>
    </message>
    <message>
        <source>There are only dots here; draw the edges of a solid.</source>
        <translation>Hier sind nur Punkte; zu zeichnen sind die Kanten eines Körpers.</translation>
    </message>
    <message>
        <source>These are %1 separate drawings; apply them one at a time.</source>
        <translation>Das sind %1 getrennte Zeichnungen; sie gehören einzeln angewendet.</translation>
    </message>
    <message>
        <source>This corner cannot be right-angled: at a Y all three angles must be over 90 degrees, at an arrow both inner angles under 90 with a sum over 90.</source>
        <translation>Diese Ecke kann nicht rechtwinklig sein: Bei einem Y müssen alle drei Winkel über 90 Grad liegen, bei einem Pfeil beide inneren unter 90 und zusammen über 90.</translation>
    </message>
    <message>
        <source>Lines cross at %1 where no corner is; draw visible edges only, or drop a line.</source>
        <translation>Linien kreuzen sich an %1 ohne Ecke; nur sichtbare Kanten zeichnen oder eine Linie verwerfen.</translation>
    </message>
    <message>
        <source>The lines fit no %1 closely: they are %2 off on average.</source>
        <translation>Als %1 passen die Linien schlecht: Sie liegen im Mittel %2 daneben.</translation>
    </message>
    <message>
        <source>This could be %1, but only without some of the lines; choose it, or draw on.</source>
        <translation>Lesbar als %1, aber nur ohne einige der Linien; auswählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>This could be %1, but only with edges that are not drawn; choose it, or draw on.</source>
        <translation>Lesbar als %1, aber nur mit Kanten, die nicht gezeichnet sind; auswählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>This could be %1, but it would run through the solid that is there; choose it, or draw on.</source>
        <translation>Lesbar als %1, ginge aber durch den vorhandenen Körper hindurch; auswählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>This could be %1 of these lengths; choose it, or draw on.</source>
        <translation>Lesbar als %1 mit diesen Längen; auswählen oder weiterzeichnen.</translation>
    </message>
    <message>
        <source>This is one flat outline; a solid needs the lines inside it too, where its faces meet.</source>
        <translation>Das ist ein flacher Umriss; ein Körper braucht auch die Linien darin, an denen seine Flächen sich treffen.</translation>
    </message>
    <message>
        <source>Just two faces are drawn here; this could be %1. Choose it, or draw the third face.</source>
        <translation>Hier sind nur zwei Flächen gezeichnet; das könnte %1 sein. Wählen oder die dritte Fläche zeichnen.</translation>
    </message>
    <message>
        <source>As it is drawn %1 would be far deeper than it is wide, or hardly thicker than a line; choose it, or draw it from another side.</source>
        <translation>So gezeichnet wäre %1 viel tiefer als breit oder kaum dicker als eine Linie; wählen oder von einer anderen Seite zeichnen.</translation>
    </message>
    <message>
        <source>Seen from here this could be %1, or something simpler; choose it, or turn the view and draw again.</source>
        <translation>Von hier aus lesbar als %1 oder etwas Einfacheres; auswählen, oder die Ansicht drehen und neu zeichnen.</translation>
    </message>
    <message>
        <source>No template shows %1 and %2 like this. The nearest is %3, but the lines meet in another way.</source>
        <translation>Keine Vorlage zeigt so %1 und %2. Am nächsten ist: %3, aber dort treffen sich die Linien anders.</translation>
    </message>
    <message>
        <source>No template shows %1 and %2 like this.</source>
        <translation>Keine Vorlage zeigt so %1 und %2.</translation>
    </message>
    <message>
        <source>No template matches this drawing.</source>
        <translation>Keine Vorlage passt zu dieser Zeichnung.</translation>
    </message>
    <message>
        <source>These lines and the edges that they meet show no template on the solid.</source>
        <translation>Diese Linien und die Kanten, die sie treffen, zeigen keine Vorlage am Körper.</translation>
    </message>
    <message>
        <source>These lines are edges of the solid already: nothing would change.</source>
        <translation>Diese Linien sind schon Kanten des Körpers: Nichts würde sich ändern.</translation>
    </message>
    <message>
        <source>There is no template &quot;%1&quot; in the library.</source>
        <translation>Es gibt keine Vorlage „%1“ in der Bibliothek.</translation>
    </message>
    <message>
        <source>There are %1 strokes; at most %2 are read at once.</source>
        <translation>Das sind %1 Striche; höchstens %2 werden auf einmal gelesen.</translation>
    </message>
    <message>
        <source>There are more lines than the %1 that are read at once; draw one solid at a time.</source>
        <translation>Das sind mehr Linien als die %1, die auf einmal gelesen werden; Körper einzeln zeichnen.</translation>
    </message>
    <message>
        <source>There are %1 pending strokes already; apply or clear them first.</source>
        <translation>Es gibt schon %1 offene Striche; sie zuerst anwenden oder verwerfen.</translation>
    </message>
    <message>
        <source>Nothing was made or changed yet.</source>
        <translation>Noch wurde nichts angelegt oder geändert.</translation>
    </message>
    <message>
        <source>More solids were made than are wanted; draw one at a time.</source>
        <translation>Es sind mehr Körper entstanden als gewünscht; zeichne einen nach dem anderen.</translation>
    </message>
    <message>
        <source>It was done to the wrong side: what was to be added was cut, or the other way round.</source>
        <translation>Es ging zur falschen Seite: Was hinzukommen sollte, wurde abgezogen, oder umgekehrt.</translation>
    </message>
    <message>
        <source>It became another kind of shape.</source>
        <translation>Es wurde eine andere Form daraus.</translation>
    </message>
    <message>
        <source>The shape is right, but it is in the wrong place.</source>
        <translation>Die Form stimmt, aber sie ist an der falschen Stelle.</translation>
    </message>
    <message>
        <source>The shape is right, but its proportions are far from the wanted ones.</source>
        <translation>Die Form stimmt, aber ihre Proportionen sind weit von den gewünschten entfernt.</translation>
    </message>
    <message>
        <source>It was done with other edges, another size or another kind of surface.</source>
        <translation>Es waren andere Kanten, eine andere Größe oder eine andere Art von Oberfläche.</translation>
    </message>
    <message>
        <source>The lesson has %1 steps.</source>
        <translation>Die Lektion hat %1 Schritte.</translation>
    </message>
    <message>
        <source>A lesson has no step %1.</source>
        <translation>Eine Lektion hat keinen Schritt %1.</translation>
    </message>
    <message>
        <source>Nothing is drawn yet.</source>
        <translation>Es ist noch nichts gezeichnet.</translation>
    </message>
    <message>
        <source>There is no stroke within reach to erase.</source>
        <translation>In Reichweite ist kein Strich zum Radieren.</translation>
    </message>
    <message>
        <source>There is no solid to cut.</source>
        <translation>Es gibt keinen Körper, von dem etwas abzuziehen wäre.</translation>
    </message>
    <message>
        <source>There is no solid to add to.</source>
        <translation>Es gibt keinen Körper, dem etwas hinzuzufügen wäre.</translation>
    </message>
    <message>
        <source>There is no solid to delete.</source>
        <translation>Es gibt keinen Körper zum Löschen.</translation>
    </message>
    <message>
        <source>There is no solid to export yet.</source>
        <translation>Es gibt noch keinen Körper zum Exportieren.</translation>
    </message>
    <message>
        <source>There is no solid to make a template from.</source>
        <translation>Es gibt keinen Körper, aus dem eine Vorlage werden könnte.</translation>
    </message>
    <message>
        <source>A template&apos;s faces have no holes; this solid&apos;s have.</source>
        <translation>Die Flächen einer Vorlage haben keine Löcher; die dieses Körpers haben welche.</translation>
    </message>
    <message>
        <source>This drawing cannot be read as that operation; let the program choose it.</source>
        <translation>Die Zeichnung ist nicht als dieser Vorgang lesbar; die Wahl dem Programm überlassen.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>The stroke to repair is gone.</source>
        <translation>Der Strich, der zu beheben war, ist nicht mehr da.</translation>
    </message>
    <message>
        <source>There is no file at %1.</source>
        <translation>Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>The new part lies inside the solid: nothing would change.</source>
        <translation>Das neue Teil liegt im Körper: Nichts würde sich ändern.</translation>
    </message>
    <message>
        <source>The part to cut out lies beside the solid: nothing would change.</source>
        <translation>Das abzuziehende Teil liegt neben dem Körper: Nichts würde sich ändern.</translation>
    </message>
    <message>
        <source>The solid lies inside the part: nothing would change.</source>
        <translation>Der Körper liegt im Teil: Nichts würde sich ändern.</translation>
    </message>
    <message>
        <source>Nothing of the solid would be left.</source>
        <translation>Vom Körper bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>The two parts have nothing in common.</source>
        <translation>Die beiden Teile haben nichts gemeinsam.</translation>
    </message>
    <message>
        <source>Two parts would all but touch: a wall, gap or step thinner than a hair would be left that nobody can see. Make the new part a little larger or smaller.</source>
        <translation>Zwei Teile würden sich beinahe berühren: es bliebe eine Wand, ein Spalt oder eine Stufe, dünner als ein Haar, die niemand sieht. Das neue Teil etwas größer oder kleiner zeichnen.</translation>
    </message>
    <message>
        <source>The solid would touch itself along an edge only. Make the new part a little larger or smaller.</source>
        <translation>Der Körper würde sich nur entlang einer Kante berühren. Das neue Teil etwas größer oder kleiner zeichnen.</translation>
    </message>
    <message>
        <source>The solid would touch itself in a point only. Make the new part a little larger or smaller.</source>
        <translation>Der Körper würde sich nur in einem Punkt berühren. Das neue Teil etwas größer oder kleiner zeichnen.</translation>
    </message>
    <message>
        <source>One edge that was not drawn was added.</source>
        <translation>Eine Kante, die nicht gezeichnet war, wurde ergänzt.</translation>
    </message>
    <message>
        <source>%1 edges that were not drawn were added.</source>
        <translation>%1 Kanten, die nicht gezeichnet waren, wurden ergänzt.</translation>
    </message>
    <message>
        <source>One line too many was left out.</source>
        <translation>Eine überzählige Linie wurde weggelassen.</translation>
    </message>
    <message>
        <source>Lines that run past the corners were taken for guide lines.</source>
        <translation>Linien, die über die Ecken hinauslaufen, gelten als Hilfslinien.</translation>
    </message>
    <message>
        <source>Parts that cannot be seen from here keep the template&apos;s proportions.</source>
        <translation>Was von hier nicht zu sehen ist, behält die Maße der Vorlage.</translation>
    </message>
    <message>
        <source>The corner has no exact solution; the nearest drawing that has one was taken.</source>
        <translation>Die Ecke hat keine genaue Lösung; genommen wurde die nächste Zeichnung, die eine hat.</translation>
    </message>
    <message>
        <source>Read as an oblique drawing: the front face is true, the depth is a choice.</source>
        <translation>Gelesen als Schrägbild: Die Vorderseite stimmt, die Tiefe ist wählbar.</translation>
    </message>
    <message>
        <source>The drawing leaves one measure open; the most regular shape was taken.</source>
        <translation>Die Zeichnung lässt ein Maß offen; genommen wurde die regelmäßigste Form.</translation>
    </message>
    <message>
        <source>The drawing leaves %1 measures open; the most regular shape was taken.</source>
        <translation>Die Zeichnung lässt %1 Maße offen; genommen wurde die regelmäßigste Form.</translation>
    </message>
    <message>
        <source>The solid falls into %1 separate pieces.</source>
        <translation>Der Körper zerfällt in %1 Teile.</translation>
    </message>
    <message>
        <source>A hidden face was moved so that it meets nothing undrawn.</source>
        <translation>Eine verdeckte Fläche wurde verschoben, sodass sie auf nichts trifft, was nicht gezeichnet ist.</translation>
    </message>
    <message>
        <source>Hidden faces meet faces that were not drawn on.</source>
        <translation>Verdeckte Flächen treffen auf Flächen, auf denen nichts gezeichnet ist.</translation>
    </message>
    <message>
        <source>It closes off a hollow inside the solid.</source>
        <translation>Im Inneren des Körpers wird ein Hohlraum eingeschlossen.</translation>
    </message>
    <message>
        <source>The file %1 was written by a later version of Edgewright, and what this one does not know of it would be lost; save under another name.</source>
        <translation>Die Datei %1 wurde von einer neueren Version von Edgewright geschrieben, und was diese hier nicht kennt, ginge verloren; bitte unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>The file %1 could not be written: %2.</source>
        <translation>Die Datei %1 konnte nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>A document cannot be called %1: files that end in .json are sketch scripts.</source>
        <translation>Ein Dokument kann nicht %1 heißen: Dateien mit der Endung .json sind Zeichenskripte.</translation>
    </message>
    <message>
        <source>%1 is no Edgewright document or sketch script: it holds %2.</source>
        <translation>%1 ist weder ein Edgewright-Dokument noch ein Zeichenskript; der Inhalt: %2.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MiB.</source>
        <translation>%1 ist größer als %2 MiB.</translation>
    </message>
    <message>
        <source>%1 is a folder, not a file.</source>
        <translation>%1 ist ein Ordner und keine Datei.</translation>
    </message>
    <message>
        <source>The solid lies too far out to be written to a mesh file.</source>
        <translation>Der Körper liegt zu weit draußen, um in eine Netzdatei geschrieben zu werden.</translation>
    </message>
    <message>
        <source>The bodies lie too far apart for the single precision of STL; export them as OBJ, 3MF or glTF.</source>
        <translation>Die Körper liegen zu weit auseinander für die einfache Genauigkeit von STL; OBJ, 3MF und glTF können sie halten.</translation>
    </message>
    <message>
        <source>It lies far out: in the file, the origin is at %1.</source>
        <translation>Er liegt weit draußen: In der Datei ist der Ursprung bei %1.</translation>
    </message>
    <message>
        <source>there is no room left on the disk</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>ihren Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>sie ist ein Ordner</translation>
    </message>
    <message>
        <source>it may not be changed</source>
        <translation>sie darf nicht geändert werden</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>ihr Name ist zu lang</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a ZIP package, as 3MF files are</source>
        <translation>ein ZIP-Paket, wie 3MF-Dateien es sind</translation>
    </message>
    <message>
        <source>a glTF mesh</source>
        <translation>ein glTF-Netz</translation>
    </message>
    <message>
        <source>a PLY mesh</source>
        <translation>ein PLY-Netz</translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation>ein STL-Netz</translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation>ein OBJ-Netz</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>ein STEP-Modell</translation>
    </message>
    <message>
        <source>XML text, as SVG files are</source>
        <translation>XML-Text, wie SVG-Dateien ihn enthalten</translation>
    </message>
    <message>
        <source>text of another kind</source>
        <translation>Text anderer Art</translation>
    </message>
    <message>
        <source>data of another kind</source>
        <translation>Daten anderer Art</translation>
    </message>
    <message>
        <source>Join these ends</source>
        <translation>Diese Enden verbinden</translation>
    </message>
    <message>
        <source>Raise the threshold to %1</source>
        <translation>Schwelle auf %1 erhöhen</translation>
    </message>
    <message>
        <source>Raise the angle threshold to %1 degrees</source>
        <translation>Winkelschwelle auf %1 Grad erhöhen</translation>
    </message>
    <message>
        <source>Drop this line</source>
        <translation>Diese Linie verwerfen</translation>
    </message>
    <message>
        <source>Keep the largest drawing</source>
        <translation>Größte Zeichnung behalten</translation>
    </message>
    <message>
        <source>Keep drawing %1</source>
        <translation>Zeichnung %1 behalten</translation>
    </message>
    <message>
        <source>Take the %1</source>
        <translation>Nehmen: %1</translation>
    </message>
    <message>
        <source>Take: %1</source>
        <translation>Nehmen: %1</translation>
    </message>
    <message>
        <source>a dot</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>a scribble</source>
        <translation>Gekritzel</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>eine Kurve</translation>
    </message>
    <message>
        <source>gap %1, threshold %2</source>
        <translation>Lücke %1, Schwelle %2</translation>
    </message>
    <message>
        <source>no right-angled corner looks like this</source>
        <translation>so sieht keine rechtwinklige Ecke aus</translation>
    </message>
    <message>
        <source>lines cross</source>
        <translation>Linien kreuzen sich</translation>
    </message>
    <message>
        <source>%1 degrees off its parallels</source>
        <translation>%1 Grad neben den Parallelen</translation>
    </message>
    <message>
        <source>%1 lines meet here</source>
        <translation>%1 Linien treffen sich hier</translation>
    </message>
    <message>
        <source>one place</source>
        <translation>einer Stelle</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 Stellen</translation>
    </message>
    <message>
        <source>one corner</source>
        <translation>eine Ecke</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>one edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>Parallel projection</source>
        <translation>Parallelprojektion</translation>
    </message>
    <message>
        <source>Nearest parallel projection</source>
        <translation>Nächste Parallelprojektion</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Read in perspective: lines that run away come together.</source>
        <translation>Perspektivisch gelesen: Linien, die in die Tiefe laufen, nähern sich einander.</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schrägbild</translation>
    </message>
    <message>
        <source>Most regular</source>
        <translation>Am regelmäßigsten</translation>
    </message>
    <message>
        <source>Isosceles</source>
        <translation>Gleichschenklig</translation>
    </message>
    <message>
        <source>Right-angled</source>
        <translation>Rechtwinklig</translation>
    </message>
    <message>
        <source>Right-angled corner</source>
        <translation>Rechtwinklige Ecke</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>A box: six rectangular faces, any proportions.</source>
        <translation>Sechs rechteckige Flächen, beliebige Maße.</translation>
    </message>
    <message>
        <source>L-prism</source>
        <translation>L-Prisma</translation>
    </message>
    <message>
        <source>A right prism over an L with right angles only.</source>
        <translation>Ein gerades Prisma über einem L mit lauter rechten Winkeln.</translation>
    </message>
    <message>
        <source>Triangular prism</source>
        <translation>Dreiecksprisma</translation>
    </message>
    <message>
        <source>A right prism over any triangle.</source>
        <translation>Ein gerades Prisma über einem beliebigen Dreieck.</translation>
    </message>
    <message>
        <source>Prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>%1 solids</source>
        <translation>%1 Körper</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Frustum</source>
        <translation>Stumpf</translation>
    </message>
    <message>
        <source>Triangular pyramid</source>
        <translation>Dreieckspyramide</translation>
    </message>
    <message>
        <source>Four triangles, any shape.</source>
        <translation>Vier Dreiecke, beliebige Form.</translation>
    </message>
    <message>
        <source>Wedge frustum</source>
        <translation>Pyramidenstumpf</translation>
    </message>
    <message>
        <source>A rectangular pyramid with its top cut off parallel to the base.</source>
        <translation>Eine rechteckige Pyramide, deren Spitze parallel zur Grundfläche abgeschnitten ist.</translation>
    </message>
    <message>
        <source>A box, drawn by hand</source>
        <translation>Ein Quader, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A clock, drawn by hand</source>
        <translation>Eine Uhr, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A computer mouse, drawn by hand</source>
        <translation>Eine Computermaus, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A printer, drawn by hand</source>
        <translation>Ein Drucker, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A triangular prism, drawn by hand</source>
        <translation>Ein Dreiecksprisma, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A triangular pyramid, drawn by hand</source>
        <translation>Eine Dreieckspyramide, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>A wedge frustum, drawn by hand</source>
        <translation>Ein Pyramidenstumpf, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>An L-prism, drawn by hand</source>
        <translation>Ein L-Prisma, von Hand gezeichnet</translation>
    </message>
    <message>
        <source>This can be read as %1; choose one.</source>
        <translation>Lesbar als %1; bitte auswählen.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>There is no solid yet.</source>
        <translation>Es gibt noch keinen Körper.</translation>
    </message>
    <message>
        <source>No edge is chosen.</source>
        <translation>Es ist keine Kante gewählt.</translation>
    </message>
    <message>
        <source>An edge that was chosen does not exist.</source>
        <translation>Eine gewählte Kante gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no edge at this place.</source>
        <translation>An dieser Stelle ist keine Kante.</translation>
    </message>
    <message>
        <source>The solid has no concave edge.</source>
        <translation>Der Körper hat keine konkave Kante.</translation>
    </message>
    <message>
        <source>The solid has no such edge.</source>
        <translation>Der Körper hat keine solche Kante.</translation>
    </message>
    <message>
        <source>None of these edges is filleted.</source>
        <translation>Keine dieser Kanten ist verrundet.</translation>
    </message>
    <message>
        <source>The radius of a fillet must be a number greater than 0 mm.</source>
        <translation>Der Radius einer Verrundung muss größer als 0 mm sein.</translation>
    </message>
    <message>
        <source>A fillet has from 1 to %1 segments across.</source>
        <translation>Eine Verrundung hat quer 1 bis %1 Segmente.</translation>
    </message>
    <message>
        <source>The sharpness of an edge must be from 0 (smooth) to 10 (sharp).</source>
        <translation>Die Schärfe einer Kante muss von 0 (glatt) bis 10 (scharf) sein.</translation>
    </message>
    <message>
        <source>The tolerance of the surface must be greater than 0 mm.</source>
        <translation>Die Toleranz der Fläche muss größer als 0 mm sein.</translation>
    </message>
    <message>
        <source>The surface has from 1 to %1 levels.</source>
        <translation>Die Fläche hat 1 bis %1 Stufen.</translation>
    </message>
    <message>
        <source>There is no solid to make a surface over yet.</source>
        <translation>Es gibt noch keinen Körper, über den eine Fläche zu legen wäre.</translation>
    </message>
    <message>
        <source>The surface would need about %1 MiB, more than the limit of %2 MiB. Choose fewer levels or a coarser tolerance.</source>
        <translation>Die Fläche bräuchte etwa %1 MiB, mehr als die Grenze von %2 MiB. Weniger Stufen oder eine gröbere Toleranz wählen.</translation>
    </message>
    <message>
        <source>The surface would need more memory than is allowed; choose fewer levels or a larger tolerance.</source>
        <translation>Die Fläche bräuchte mehr Speicher, als erlaubt ist; weniger Stufen oder eine größere Toleranz wählen.</translation>
    </message>
    <message>
        <source>The outline of face %1 crosses itself.</source>
        <translation>Der Umriss von Fläche %1 kreuzt sich selbst.</translation>
    </message>
    <message>
        <source>The outline of face %1 crosses or touches itself.</source>
        <translation>Der Umriss von Fläche %1 kreuzt oder berührt sich selbst.</translation>
    </message>
    <message>
        <source>There is no surface under the strokes.</source>
        <translation>Unter den Strichen ist keine Oberfläche.</translation>
    </message>
    <message>
        <source>There is no stroke on the surface.</source>
        <translation>Auf der Oberfläche ist kein Strich.</translation>
    </message>
    <message>
        <source>There is nothing to export yet.</source>
        <translation>Es gibt noch nichts zu exportieren.</translation>
    </message>
    <message>
        <source>In the single precision of this format the shape would not be closed: parts are too thin for it, or too far from the origin. Use .obj or .ply, or change the shape.</source>
        <translation>In der einfachen Genauigkeit dieses Formats wäre die Form nicht geschlossen: Teile sind zu dünn dafür oder zu weit vom Ursprung entfernt. Verwenden Sie .obj oder .ply, oder ändern Sie die Form.</translation>
    </message>
    <message>
        <source>The extension %1 names no mesh format; use .obj, .stl, .ply, .glb or .3mf.</source>
        <translation>Die Endung %1 steht für kein Netzformat; möglich sind .obj, .stl, .ply, .glb und .3mf.</translation>
    </message>
    <message>
        <source>A file name without an extension names no mesh format; use .obj, .stl, .ply, .glb or .3mf.</source>
        <translation>Ein Dateiname ohne Endung steht für kein Netzformat; möglich sind .obj, .stl, .ply, .glb und .3mf.</translation>
    </message>
    <message>
        <source>The surface is too large for a glTF file of 4 GiB.</source>
        <translation>Die Fläche ist zu groß für eine glTF-Datei von 4 GiB.</translation>
    </message>
    <message>
        <source>Edge %1 (%2 long): %3 instead of %4, its own length leaves no more room</source>
        <translation>Kante %1 (%2 lang): %3 statt %4, die eigene Länge lässt nicht mehr Platz</translation>
    </message>
    <message>
        <source>Edge %1 (%2 long): %3 instead of %4, edge %5 leaves no more room</source>
        <translation>Kante %1 (%2 lang): %3 statt %4, Kante %5 lässt nicht mehr Platz</translation>
    </message>
    <message>
        <source>Edge %1 (%2 long): %3 instead of %4, corner %5 leaves no more room</source>
        <translation>Kante %1 (%2 lang): %3 statt %4, Ecke %5 lässt nicht mehr Platz</translation>
    </message>
    <message>
        <source>Edge %1 (%2 long): %3 instead of %4</source>
        <translation>Kante %1 (%2 lang): %3 statt %4</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>Radius %1</translation>
    </message>
    <message>
        <source>stays sharp</source>
        <translation>bleibt scharf</translation>
    </message>
    <message>
        <source>This could be %1, but an edge is %2 degrees off its parallels (the angle threshold is %3).</source>
        <translation>Lesbar als %1, aber eine Kante weicht um %2 Grad von ihren Parallelen ab (die Winkelschwelle ist %3).</translation>
    </message>
    <message>
        <source>Seen from here %1 looks like simpler solids; choose it, or turn the view and draw again.</source>
        <translation>Von hier aus sieht %1 wie einfachere Körper aus; auswählen, oder die Ansicht drehen und neu zeichnen.</translation>
    </message>
    <message>
        <source>Take it as %1 all the same</source>
        <translation>Trotzdem nehmen: %1</translation>
    </message>
    <message>
        <source>Take it as %1</source>
        <translation>Nehmen: %1</translation>
    </message>
    <message>
        <source>adding %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>cutting %1</source>
        <translation>%1 abziehen</translation>
    </message>
    <message>
        <source>a %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>an %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>an L-prism</source>
        <translation>L-Prisma</translation>
    </message>
    <message>
        <source>a prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <source>a pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>a frustum</source>
        <translation>Pyramidenstumpf</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be opened whole: %2.</source>
        <translation>%1 ist beschädigt und lässt sich nicht ganz öffnen: %2.</translation>
    </message>
    <message>
        <source>%1: The document was written by a later version (its schema is %2, this program reads up to %3); a later version of Edgewright is needed.</source>
        <translation>%1: Das Dokument wurde von einer neueren Version geschrieben (Schema %2, dieses Programm liest bis %3); eine neuere Version von Edgewright wird gebraucht.</translation>
    </message>
    <message>
        <source>%1: The document was written by a later version (its schema is %2, this program reads up to %3); Edgewright %4 or later is needed.</source>
        <translation>%1: Das Dokument stammt von einer späteren Version (sein Schema ist %2, dieses Programm liest bis %3); nötig ist Edgewright %4 oder später.</translation>
    </message>
    <message>
        <source>Another window has this document open.</source>
        <translation>Ein anderes Fenster hat dieses Dokument offen.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made or written to.</source>
        <translation>Der Ordner %1 lässt sich nicht anlegen oder beschreiben.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>the file cannot be read or written (%1)</source>
        <translation>die Datei lässt sich nicht lesen oder schreiben (%1)</translation>
    </message>
    <message>
        <source>No template shows %1 and %2 like this. The nearest is %3 (%4 missing, %5 too many).</source>
        <translation>Keine Vorlage zeigt so %1 und %2. Am nächsten ist: %3 (zu wenig: %4, zu viel: %5).</translation>
    </message>
    <message>
        <source>No template shows %1 and %2 like this. The nearest is %3 (%4 missing).</source>
        <translation>Keine Vorlage zeigt so %1 und %2. Am nächsten ist: %3 (zu wenig: %4).</translation>
    </message>
    <message>
        <source>No template shows %1 and %2 like this. The nearest is %3 (%4 too many).</source>
        <translation>Keine Vorlage zeigt so %1 und %2. Am nächsten ist: %3 (zu viel: %4).</translation>
    </message>
    <message>
        <source>Join the nearest ends</source>
        <translation>Die nächsten Enden verbinden</translation>
    </message>
    <message>
        <source>is part of no face</source>
        <translation>gehört zu keiner Fläche</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>eine Linie</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Linien</translation>
    </message>
    <message>
        <source>a database of another program</source>
        <translation>eine Datenbank eines anderen Programms</translation>
    </message>
    <message>
        <source>%1: not valid JSON at byte %2</source>
        <translation>%1: kein gültiges JSON bei Byte %2</translation>
    </message>
    <message>
        <source>%1: the key %2 comes twice in one object</source>
        <translation>%1: der Schlüssel %2 steht zweimal in einem Objekt</translation>
    </message>
    <message>
        <source>%1: a number before byte %2 is beyond the range of numbers</source>
        <translation>%1: eine Zahl vor Byte %2 ist größer, als Zahlen sein können</translation>
    </message>
    <message>
        <source>%1: the file holds too many values</source>
        <translation>%1: die Datei enthält zu viele Werte</translation>
    </message>
    <message>
        <source>%1: nested deeper than %2 levels</source>
        <translation>%1: tiefer als %2 Stufen verschachtelt</translation>
    </message>
    <message>
        <source>%1: larger than %2 MiB</source>
        <translation>%1: größer als %2 MiB</translation>
    </message>
    <message>
        <source>%1: this is not a sketch script (its format is %2)</source>
        <translation>%1: das ist kein Zeichenskript (sein Format ist %2)</translation>
    </message>
    <message>
        <source>%1: this is not an Edgewright document (its format is %2)</source>
        <translation>%1: das ist kein Edgewright-Dokument (sein Format ist %2)</translation>
    </message>
    <message>
        <source>%1: version %2 is not known; this program reads version 1</source>
        <translation>%1: Version %2 ist nicht bekannt; dieses Programm liest Version 1</translation>
    </message>
    <message>
        <source>%1: more than %2 steps</source>
        <translation>%1: mehr als %2 Schritte</translation>
    </message>
    <message>
        <source>%1: %2: the key %3 or %4 is missing</source>
        <translation>%1: %2: der Schlüssel %3 oder %4 fehlt</translation>
    </message>
    <message>
        <source>%1: %2: the key %3 is missing</source>
        <translation>%1: %2: der Schlüssel %3 fehlt</translation>
    </message>
    <message>
        <source>%1: %2: unknown key %3</source>
        <translation>%1: %2: unbekannter Schlüssel %3</translation>
    </message>
    <message>
        <source>%1: %2: either %3 or %4, not both</source>
        <translation>%1: %2: entweder %3 oder %4, nicht beide</translation>
    </message>
    <message>
        <source>%1: %2: there is no step called %3</source>
        <translation>%1: %2: es gibt keinen Schritt namens %3</translation>
    </message>
    <message>
        <source>%1: %2: the pressure must be from 0 to 1</source>
        <translation>%1: %2: der Druck muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>%1: %2 names no edge</source>
        <translation>%1: %2 nennt keine Kante</translation>
    </message>
    <message>
        <source>%1: %2 is too far away</source>
        <translation>%1: %2 ist zu weit entfernt</translation>
    </message>
    <message>
        <source>%1: %2 must hold numbers only</source>
        <translation>%1: %2 darf nur Zahlen enthalten</translation>
    </message>
    <message>
        <source>%1: %2 must name a template</source>
        <translation>%1: %2 muss eine Vorlage nennen</translation>
    </message>
    <message>
        <source>%1: %2 must name a file</source>
        <translation>%1: %2 muss eine Datei nennen</translation>
    </message>
    <message>
        <source>%1: %2 must be a direction, not zero and not huge</source>
        <translation>%1: %2 muss eine Richtung sein, nicht null und nicht riesig</translation>
    </message>
    <message>
        <source>%1: %2 must be a list of %3 numbers</source>
        <translation>%1: %2 muss eine Liste aus %3 Zahlen sein</translation>
    </message>
    <message>
        <source>%1: %2 must be a colour such as %3</source>
        <translation>%1: %2 muss eine Farbe wie %3 sein</translation>
    </message>
    <message>
        <source>%1: %2 must be auto or a number from 0 to 10</source>
        <translation>%1: %2 muss auto oder eine Zahl von 0 bis 10 sein</translation>
    </message>
    <message>
        <source>%1: %2 must be from %3 to %4 pixels each way</source>
        <translation>%1: %2 muss in jeder Richtung %3 bis %4 Pixel groß sein</translation>
    </message>
    <message>
        <source>%1: %2 must be from %3 to %4</source>
        <translation>%1: %2 muss zwischen %3 und %4 liegen</translation>
    </message>
    <message>
        <source>%1: %2 must be greater than %3</source>
        <translation>%1: %2 muss größer als %3 sein</translation>
    </message>
    <message>
        <source>%1: %2 must be %3, not %4</source>
        <translation>%1: %2 muss %3 sein, nicht %4</translation>
    </message>
    <message>
        <source>%1: %2 must be %3</source>
        <translation>%1: %2 muss %3 sein</translation>
    </message>
    <message>
        <source>script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>wahr oder falsch</translation>
    </message>
    <message>
        <source>script: %1</source>
        <translation>Skript: %1</translation>
    </message>
    <message>
        <source>%1: script</source>
        <translation>%1: Skript</translation>
    </message>
    <message>
        <source>step %1 (%2): %3</source>
        <translation>Schritt %1 (%2): %3</translation>
    </message>
    <message>
        <source>step %1 (%2)</source>
        <translation>Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>%1 is no file of this computer; only those can be opened.</source>
        <translation>%1 ist keine Datei dieses Rechners; nur solche können geöffnet werden.</translation>
    </message>
    <message>
        <source>There is no body number %1; the document has %2, counted from 0.</source>
        <translation>Es gibt keinen Körper Nummer %1; das Dokument hat %2, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>A name has at most %1 characters.</source>
        <translation>Ein Name hat höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>This step read no drawing.</source>
        <translation>Dieser Schritt hat keine Zeichnung gelesen.</translation>
    </message>
    <message>
        <source>A step can only become another step of its kind.</source>
        <translation>Ein Schritt kann nur zu einem Schritt derselben Art werden.</translation>
    </message>
    <message>
        <source>How this step was made is not known any more.</source>
        <translation>Wie dieser Schritt entstand, ist nicht mehr bekannt.</translation>
    </message>
    <message>
        <source>There is no such step in the history.</source>
        <translation>Im Verlauf gibt es keinen solchen Schritt.</translation>
    </message>
    <message>
        <source>A pupil has a name.</source>
        <translation>Zu einem Schüler gehört ein Name.</translation>
    </message>
    <message>
        <source>A pupil&apos;s name has at most %1 letters.</source>
        <translation>Der Name eines Schülers hat höchstens %1 Buchstaben.</translation>
    </message>
    <message>
        <source>A pupil&apos;s name has letters only that can be seen.</source>
        <translation>Der Name eines Schülers hat nur Buchstaben, die man sieht.</translation>
    </message>
    <message>
        <source>There is no class folder at %1.</source>
        <translation>Unter %1 gibt es keinen Klassenordner.</translation>
    </message>
    <message>
        <source>The class folder %1 may not be read.</source>
        <translation>Der Klassenordner %1 darf nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There are too many folders for one name in %1.</source>
        <translation>In %1 gibt es zu viele Ordner für einen Namen.</translation>
    </message>
    <message>
        <source>%1 cannot be read; it was left as it is, and the work goes on in %2.</source>
        <translation>%1 ist nicht lesbar und blieb, wie es ist; die Arbeit geht in %2 weiter.</translation>
    </message>
    <message>
        <source>The class folder %1 is gone. Put the stick back in, or connect the share again.</source>
        <translation>Der Klassenordner %1 ist weg. Steck den Stick wieder ein, oder verbinde die Freigabe neu.</translation>
    </message>
    <message>
        <source>Another machine (%1) writes to %2, too. That was left as it is, and the work goes on in %3.</source>
        <translation>Ein anderer Rechner (%1) schreibt auch in %2. Was dort liegt, blieb, wie es ist; die Arbeit geht in %3 weiter.</translation>
    </message>
    <message>
        <source>%1 was written by a later version of the program and is left as it is.</source>
        <translation>%1 wurde von einer neueren Version des Programms geschrieben und bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>What could not be written to the class folder last time was brought there now.</source>
        <translation>Was letztes Mal nicht in den Klassenordner geschrieben werden konnte, wurde jetzt dorthin gebracht.</translation>
    </message>
    <message>
        <source>%1: This is no pupil&apos;s folder; it was left as it is.</source>
        <translation>%1: Das ist kein Ordner eines Schülers; er blieb, wie er ist.</translation>
    </message>
    <message>
        <source>%1: this is no pupil&apos;s progress</source>
        <translation>%1: das ist nicht der Fortschritt eines Schülers</translation>
    </message>
    <message>
        <source>%1: this program reads version 1</source>
        <translation>%1: dieses Programm liest Version 1</translation>
    </message>
    <message>
        <source>%1: another lesson has this id, too</source>
        <translation>%1: eine andere Lektion hat auch diese Kennung</translation>
    </message>
    <message>
        <source>Class overview: %1</source>
        <translation>Klassenübersicht: %1</translation>
    </message>
    <message>
        <source>Pupils: %1; stuck: %2; lessons: %3.</source>
        <translation>Schüler: %1; hängen fest: %2; Lektionen: %3.</translation>
    </message>
    <message>
        <source>Files that could not be read</source>
        <translation>Dateien, die nicht gelesen werden konnten</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, Schritt %2</translation>
    </message>
    <message>
        <source>%1 attempts, the last one: %2</source>
        <translation>%1 Versuche, der letzte: %2</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>from another machine</source>
        <translation>von einem anderen Rechner</translation>
    </message>
    <message>
        <source>Pupil</source>
        <translation>Schüler</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>Hängt fest</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Stars</source>
        <translation>Sterne</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Last worked</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Steps done</source>
        <translation>Fertige Schritte</translation>
    </message>
    <message>
        <source>Most stars</source>
        <translation>Mögliche Sterne</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Failed attempts</source>
        <translation>Fehlversuche</translation>
    </message>
    <message>
        <source>Stuck at step</source>
        <translation>Hängt fest bei Schritt</translation>
    </message>
    <message>
        <source>Stuck since</source>
        <translation>Hängt fest seit</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>nothing was made</source>
        <translation>es wurde nichts gemacht</translation>
    </message>
    <message>
        <source>it was done to the wrong side</source>
        <translation>auf der falschen Seite</translation>
    </message>
    <message>
        <source>another kind of shape</source>
        <translation>eine andere Form</translation>
    </message>
    <message>
        <source>the wrong place</source>
        <translation>an der falschen Stelle</translation>
    </message>
    <message>
        <source>other proportions</source>
        <translation>andere Proportionen</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>andere Einstellungen</translation>
    </message>
    <message>
        <source>several drawings at once</source>
        <translation>mehrere Zeichnungen auf einmal</translation>
    </message>
    <message>
        <source>a corner is open</source>
        <translation>eine Ecke ist offen</translation>
    </message>
    <message>
        <source>a line is missing</source>
        <translation>eine Linie fehlt</translation>
    </message>
    <message>
        <source>a line is too many</source>
        <translation>eine Linie ist zu viel</translation>
    </message>
    <message>
        <source>an edge at the back was drawn</source>
        <translation>eine hintere Kante wurde gezeichnet</translation>
    </message>
    <message>
        <source>a line is curved</source>
        <translation>eine Linie ist krumm</translation>
    </message>
    <message>
        <source>the drawing is too small</source>
        <translation>die Zeichnung ist zu klein</translation>
    </message>
    <message>
        <source>an outline with no lines in it</source>
        <translation>ein Umriss ohne Linien darin</translation>
    </message>
    <message>
        <source>a shape that is not known</source>
        <translation>eine unbekannte Form</translation>
    </message>
    <message>
        <source>an impossible corner</source>
        <translation>eine unmögliche Ecke</translation>
    </message>
    <message>
        <source>lines are not parallel</source>
        <translation>Linien sind nicht parallel</translation>
    </message>
    <message>
        <source>it can be read in several ways</source>
        <translation>es lässt sich auf mehrere Arten lesen</translation>
    </message>
    <message>
        <source>the lines enclose nothing</source>
        <translation>die Linien umschließen nichts</translation>
    </message>
    <message>
        <source>no line could be read</source>
        <translation>keine Linie war lesbar</translation>
    </message>
    <message>
        <source>nothing was drawn</source>
        <translation>es wurde nichts gezeichnet</translation>
    </message>
    <message>
        <source>a drawing in perspective</source>
        <translation>eine Zeichnung in Perspektive</translation>
    </message>
    <message>
        <source>A level is from 1 to %1.</source>
        <translation>Eine Stufe ist von 1 bis %1.</translation>
    </message>
    <message>
        <source>No exercise was found for this number; try another one.</source>
        <translation>Für diese Nummer wurde keine Übung gefunden; nimm eine andere.</translation>
    </message>
    <message>
        <source>a template has 4 to 64 vertices, not %1.</source>
        <translation>Eine Vorlage hat 4 bis 64 Ecken, nicht %1.</translation>
    </message>
    <message>
        <source>The solid cuts through itself.</source>
        <translation>Der Körper durchdringt sich selbst.</translation>
    </message>
    <message>
        <source>The faces of the solid point inwards.</source>
        <translation>Die Flächen des Körpers zeigen nach innen.</translation>
    </message>
    <message>
        <source>Faces %1 and %2 cut through or touch each other.</source>
        <translation>Die Flächen %1 und %2 durchdringen oder berühren sich.</translation>
    </message>
    <message>
        <source>coordinates must be finite and at most 1000000.</source>
        <translation>Koordinaten müssen endlich und höchstens 1000000 sein.</translation>
    </message>
    <message>
        <source>vertex %1 is off the face&apos;s plane.</source>
        <translation>Ecke %1 liegt nicht in der Ebene der Fläche.</translation>
    </message>
    <message>
        <source>edge %1 has no length.</source>
        <translation>Kante %1 hat keine Länge.</translation>
    </message>
    <message>
        <source>the face has no area.</source>
        <translation>die Fläche hat keinen Inhalt.</translation>
    </message>
    <message>
        <source>the shape is too small.</source>
        <translation>die Form ist zu klein.</translation>
    </message>
    <message>
        <source>lies in one plane with face %1; make them one face.</source>
        <translation>liegt in einer Ebene mit Fläche %1; beide sollten eine sein.</translation>
    </message>
    <message>
        <source>edges %1 and %2 are parallel too; they cannot be both.</source>
        <translation>Die Kanten %1 und %2 sind auch parallel; beides zugleich geht nicht.</translation>
    </message>
    <message>
        <source>edge %1 runs against its own class.</source>
        <translation>Kante %1 läuft ihren Parallelen entgegen.</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Both sides at once</source>
        <translation>Beide Seiten zugleich</translation>
    </message>
    <message>
        <source>Sketch, Mirror plane: what you draw, pull and round is done on both sides of it</source>
        <translation>Zeichnung, Spiegelebene: Was gezeichnet, gezogen und gerundet wird, geschieht auf beiden Seiten</translation>
    </message>
    <message>
        <source>Pull a face</source>
        <translation>Eine Fläche ziehen</translation>
    </message>
    <message>
        <source>L: drag it, or click it and type a distance; a number typed after a pull corrects it</source>
        <translation>L: ziehen, oder anklicken und eine Strecke eintippen; eine Zahl nach dem Zug berichtigt ihn</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>sums and units count: 120/3 + 2, 2.5 cm, 1 1/2 in; a comma is a decimal mark, too</source>
        <translation>Rechnungen und Einheiten gelten: 120/3 + 2, 2,5 cm, 1 1/2 in; ein Punkt trennt auch Dezimalen</translation>
    </message>
    <message>
        <source>Several solids</source>
        <translation>Mehrere Körper</translation>
    </message>
    <message>
        <source>the Solids panel shows, hides, names, moves, copies, joins and deletes them</source>
        <translation>das Feld „Körper“ zeigt, verbirgt, benennt, bewegt, kopiert, verbindet und löscht sie</translation>
    </message>
    <message>
        <source>In five lines</source>
        <translation>In fünf Zeilen</translation>
    </message>
    <message>
        <source>Draw the edges that you would see of a box, in any order; one stroke may draw several edges.</source>
        <translation>Die Kanten zeichnen, die von einem Quader zu sehen wären, in beliebiger Reihenfolge; ein Strich darf mehrere Kanten zeichnen.</translation>
    </message>
    <message>
        <source>The Edge Graph panel shows lines and corners as they are read; the drawing shows a faint preview.</source>
        <translation>Das Feld Kantengraph zeigt Linien und Ecken, wie sie gelesen werden; in der Zeichnung erscheint eine blasse Vorschau.</translation>
    </message>
    <message>
        <source>Lift the pen. When the reading is clear it becomes a solid; Enter does it at once.</source>
        <translation>Den Stift absetzen. Eine eindeutige Lesart wird zum Körper; mit der Eingabetaste sofort.</translation>
    </message>
    <message>
        <source>Draw on the solid to add to it (green) or to cut it (red). Keys 1 to 9 take another reading, also afterwards.</source>
        <translation>Auf den Körper zeichnen, um etwas hinzuzufügen (grün) oder abzuziehen (rot). Die Tasten 1 bis 9 nehmen eine andere Lesart, auch hinterher.</translation>
    </message>
    <message>
        <source>If something does not meet, it is marked, with a button that repairs it.</source>
        <translation>Was sich nicht trifft, wird markiert, mit einem Knopf, der es behebt.</translation>
    </message>
    <message>
        <source>Pen and mouse</source>
        <translation>Stift und Maus</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>pen tip, or left button</source>
        <translation>Stiftspitze oder linke Maustaste</translation>
    </message>
    <message>
        <source>Erase a stroke</source>
        <translation>Strich radieren</translation>
    </message>
    <message>
        <source>eraser end of the pen, or the eraser tool (E)</source>
        <translation>Radierende des Stifts oder Radiergummi (E)</translation>
    </message>
    <message>
        <source>Cancel a stroke</source>
        <translation>Strich abbrechen</translation>
    </message>
    <message>
        <source>Escape while drawing</source>
        <translation>Escape beim Zeichnen</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>right or middle button, Alt with left, pen&apos;s side button</source>
        <translation>rechte oder mittlere Maustaste, Alt mit links, Seitentaste des Stifts</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Shift with the middle button, Space with left</source>
        <translation>Umschalttaste mit mittlerer, Leertaste mit linker Maustaste</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>wheel, or two fingers</source>
        <translation>Mausrad oder zwei Finger</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Ctrl+Z: strokes and steps in the order in which they were made, and the stroke under way; Ctrl+Shift+Z goes forward</source>
        <translation>Strg+Z: Striche und Schritte in der Reihenfolge, in der sie gemacht wurden, und der Strich, der gerade gezeichnet wird; Strg+Umschalt+Z geht wieder vor</translation>
    </message>
    <message>
        <source>Quick help</source>
        <translation>Kurzhilfe</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>About Edgewright</source>
        <translation>Über Edgewright</translation>
    </message>
    <message>
        <source>Smooth shapes (Surface panel)</source>
        <translation>Glatte Formen (Feld Oberfläche)</translation>
    </message>
    <message>
        <source>Choose edges</source>
        <translation>Kanten wählen</translation>
    </message>
    <message>
        <source>all, convex, concave, or picked by a click (K): one edge, a loop or all edges of a face; Shift adds</source>
        <translation>alle, konvexe, konkave oder angeklickte (K): eine Kante, eine Kantenschleife oder die Kanten einer Fläche; die Umschalttaste nimmt weitere hinzu</translation>
    </message>
    <message>
        <source>Fillet</source>
        <translation>Verrunden</translation>
    </message>
    <message>
        <source>drag the radius to see it, let go to keep it; an edge without room gets a smaller radius and is listed</source>
        <translation>am Regler ziehen zeigt den Radius, loslassen übernimmt ihn; eine Kante ohne Platz bekommt einen kleineren und steht in der Liste</translation>
    </message>
    <message>
        <source>Change it later</source>
        <translation>Später ändern</translation>
    </message>
    <message>
        <source>fillets are settings: choose the edges again and drag; edges that survive a cut or an addition keep theirs</source>
        <translation>Verrundungen sind Einstellungen: Kanten wieder wählen und ziehen; was beim Abziehen oder Hinzufügen bestehen bleibt, behält seine</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>Glatte Fläche</translation>
    </message>
    <message>
        <source>S turns it on and off; levels, or a tolerance for as many triangles as are needed; C shows the cage over it</source>
        <translation>S schaltet sie ein und aus; mit Stufen oder mit einer Toleranz, die nur so viele Dreiecke nimmt wie nötig; C zeigt das Kontrollnetz darüber</translation>
    </message>
    <message>
        <source>Draw on it</source>
        <translation>Darauf zeichnen</translation>
    </message>
    <message>
        <source>B: every stroke goes onto the surface; Ctrl+M maps what is drawn already</source>
        <translation>B: jeder Strich kommt auf die Oberfläche; Strg+M projiziert, was schon gezeichnet ist</translation>
    </message>
    <message>
        <source>Turns pen strokes into solids, step by step, with a topology library.

Free software under the GNU General Public License, version 3 or later, without any warranty. Uses Qt, VTK, OpenMesh, OpenSubdiv, CGAL and Eigen.</source>
        <translation>Macht aus Stiftstrichen Schritt für Schritt Körper, mit einer Topologie-Bibliothek.

Freie Software unter der GNU General Public License, Version 3 oder später, ohne jede Gewährleistung. Verwendet Qt, VTK, OpenMesh, OpenSubdiv, CGAL und Eigen.</translation>
    </message>
    <message>
        <source>Templates of your own</source>
        <translation>Eigene Vorlagen</translation>
    </message>
    <message>
        <source>Make one</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Sketch, Template editor: it begins with the solid; a template, or a prism, pyramid or frustum over any polygon, can take its place</source>
        <translation>Zeichnung, Vorlageneditor: Er beginnt mit dem Körper; eine Vorlage, oder ein Prisma, eine Pyramide oder ein Stumpf über einem beliebigen Vieleck, kann an seine Stelle treten</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>what is ticked holds for every drawing of it; point at a rule and its edges light up</source>
        <translation>Was angehakt ist, gilt für jede Zeichnung davon; wird auf eine Regel gezeigt, leuchten ihre Kanten</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>from where it can be drawn, and which other template looks the same from there; a click turns the shape</source>
        <translation>von wo sie gezeichnet werden kann, und welche andere Vorlage von dort gleich aussieht; ein Klick dreht die Form</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Change or copy one</source>
        <translation>Ändern oder kopieren</translation>
    </message>
    <message>
        <source>right click in the T-LIB panel; templates of the document are edited, all can be duplicated</source>
        <translation>Rechtsklick im Bereich T-LIB; Vorlagen des Dokuments lassen sich bearbeiten, alle duplizieren</translation>
    </message>
    <message>
        <source>draw it on the sheet and see whether it is read, before it is added to the document; Mix-ups counts how often it would be taken for another</source>
        <translation>auf dem Blatt zeichnen und sehen, ob sie gelesen wird, bevor sie in das Dokument kommt; Verwechslungen zählt, wie oft sie für eine andere gehalten würde</translation>
    </message>
</context>
<context>
    <name>PracticeCurve</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>mirror_plane</source>
        <translation>Spiegelebene</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>move_body</source>
        <translation>Körper bewegen</translation>
    </message>
    <message>
        <source>name_body</source>
        <translation>Körper benennen</translation>
    </message>
    <message>
        <source>show_body</source>
        <translation>Körper zeigen</translation>
    </message>
    <message>
        <source>delete_body</source>
        <translation>Körper löschen</translation>
    </message>
    <message>
        <source>combine_bodies</source>
        <translation>Körper verbinden</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>thresholds</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>fillet</source>
        <translation>Verrunden</translation>
    </message>
    <message>
        <source>sharpen</source>
        <translation>Schärfen</translation>
    </message>
    <message>
        <source>crease</source>
        <translation>Kantenschärfe</translation>
    </message>
    <message>
        <source>subdivide</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>map_strokes</source>
        <translation>Striche projizieren</translation>
    </message>
    <message>
        <source>unmap_strokes</source>
        <translation>Striche entfernen</translation>
    </message>
    <message>
        <source>define_template</source>
        <translation>Vorlage festlegen</translation>
    </message>
    <message>
        <source>delete_solid</source>
        <translation>Körper löschen</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Benennen</translation>
    </message>
    <message>
        <source>compact</source>
        <translation>Verdichten</translation>
    </message>
</context>
<context>
    <name>ew::BodyPanel</name>
    <message>
        <source>%1 × %2 × %3 mm, volume %4 cm³</source>
        <translation>%1 × %2 × %3 mm, Volumen %4 cm³</translation>
    </message>
    <message>
        <source>Solid %1</source>
        <translation>Körper %1</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Move…</source>
        <translation>Bewegen …</translation>
    </message>
    <message>
        <source>Move, turn, scale or mirror the chosen solid by numbers</source>
        <translation>Den gewählten Körper mit Zahlen bewegen, drehen, skalieren oder spiegeln</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Put a copy of the chosen solid beside it</source>
        <translation>Eine Kopie neben den gewählten Körper stellen</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Make one solid of two chosen ones that touch</source>
        <translation>Aus zwei gewählten Körpern, die sich berühren, einen machen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the chosen solids</source>
        <translation>Die gewählten Körper löschen</translation>
    </message>
    <message>
        <source>The check mark shows or hides it; double click to name it.</source>
        <translation>Das Häkchen blendet ihn ein oder aus; ein Doppelklick benennt ihn.</translation>
    </message>
    <message>
        <source>Name…</source>
        <translation>Benennen …</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Subtract the second from the first</source>
        <translation>Den zweiten vom ersten abziehen</translation>
    </message>
</context>
<context>
    <name>ew::CandidateCard</name>
    <message>
        <source>split</source>
        <translation>teilen</translation>
    </message>
    <message>
        <source>add</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>abziehen</translation>
    </message>
    <message>
        <source>Reading %1: %2, %3, %4 % likely</source>
        <translation>Lesart %1: %2, %3, zu %4 % wahrscheinlich</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>explains all ink</source>
        <translation>erklärt alle Striche</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) not explained</source>
        <translation>
            <numerusform>%n Strich nicht erklärt</numerusform>
            <numerusform>%n Striche nicht erklärt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) not explained</source>
        <translation>
            <numerusform>%n Linie nicht erklärt</numerusform>
            <numerusform>%n Linien nicht erklärt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) not drawn</source>
        <translation>
            <numerusform>%n Kante nicht gezeichnet</numerusform>
            <numerusform>%n Kanten nicht gezeichnet</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % likely</source>
        <translation>zu %1 % wahrscheinlich</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>ew::CandidatePanel</name>
    <message>
        <source>Apply &amp;by itself when clear</source>
        <translation>Eindeutiges von &amp;selbst anwenden</translation>
    </message>
    <message>
        <source>When one reading is clearly the best, it becomes a solid about a second after the pen is lifted.</source>
        <translation>Ist eine Lesart eindeutig die beste, wird sie etwa eine Sekunde nach dem Absetzen des Stifts zum Körper.</translation>
    </message>
    <message>
        <source>Make a solid of the chosen reading (Enter)</source>
        <translation>Aus der gewählten Lesart einen Körper machen (Eingabetaste)</translation>
    </message>
    <message>
        <source>The front is taken as drawn. Depth is this many times the length of the slanted lines.</source>
        <translation>Die Vorderseite gilt, wie sie gezeichnet ist. Die Tiefe ist so viele Male die Länge der schrägen Linien.</translation>
    </message>
    <message>
        <source>Depth of the oblique reading</source>
        <translation>Tiefe der Lesart als Schrägbild</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>What the drawing can mean appears here. Keys 1 to 9 choose.</source>
        <translation>Hier erscheint, was die Zeichnung bedeuten kann. Die Tasten 1 bis 9 wählen aus.</translation>
    </message>
    <message>
        <source>Done. Another reading is one key away.</source>
        <translation>Fertig. Eine andere Lesart ist nur einen Tastendruck entfernt.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fertig.</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation>
            <numerusform>%n Lesart</numerusform>
            <numerusform>%n Lesarten</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
</context>
<context>
    <name>ew::CardDelegate</name>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
</context>
<context>
    <name>ew::ClassActions</name>
    <message>
        <source>&amp;Work in a class…</source>
        <translation>In einer Klasse &amp;arbeiten …</translation>
    </message>
    <message>
        <source>&amp;Leave the class (%1)</source>
        <translation>Klasse &amp;verlassen (%1)</translation>
    </message>
    <message>
        <source>&amp;Class overview…</source>
        <translation>&amp;Klassenübersicht …</translation>
    </message>
    <message>
        <source>Class folder</source>
        <translation>Klassenordner</translation>
    </message>
</context>
<context>
    <name>ew::ClassSession</name>
    <message>
        <source>Not kept in the class folder: %1 It is kept on this computer, and tried again.</source>
        <translation>Nicht im Klassenordner gesichert: %1 Es bleibt auf diesem Rechner und wird wieder versucht.</translation>
    </message>
    <message>
        <source>Everything is kept in the class folder again.</source>
        <translation>Im Klassenordner ist wieder alles gesichert.</translation>
    </message>
</context>
<context>
    <name>ew::Document</name>
    <message>
        <source>Set mirror plane</source>
        <translation>Spiegelebene setzen</translation>
    </message>
    <message>
        <source>Drop mirror plane</source>
        <translation>Spiegelebene aufheben</translation>
    </message>
    <message>
        <source>Cut in two</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Pull face</source>
        <translation>Fläche ziehen</translation>
    </message>
    <message>
        <source>Move solid</source>
        <translation>Körper bewegen</translation>
    </message>
    <message>
        <source>Copy solid</source>
        <translation>Körper kopieren</translation>
    </message>
    <message>
        <source>Name solid</source>
        <translation>Körper benennen</translation>
    </message>
    <message>
        <source>Show solid</source>
        <translation>Körper einblenden</translation>
    </message>
    <message>
        <source>Hide solid</source>
        <translation>Körper ausblenden</translation>
    </message>
    <message>
        <source>Join solids</source>
        <translation>Körper verbinden</translation>
    </message>
    <message>
        <source>Subtract solid</source>
        <translation>Körper abziehen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 abziehen</translation>
    </message>
    <message>
        <source>Create %1</source>
        <translation>%1 erzeugen</translation>
    </message>
    <message>
        <source>Define template “%1”</source>
        <translation>Vorlage „%1“ festlegen</translation>
    </message>
    <message>
        <source>Delete solid</source>
        <translation>Körper löschen</translation>
    </message>
    <message>
        <source>Fillet 1 edge</source>
        <translation>1 Kante verrunden</translation>
    </message>
    <message>
        <source>Fillet %1 edges</source>
        <translation>%1 Kanten verrunden</translation>
    </message>
    <message>
        <source>Sharpen 1 edge</source>
        <translation>1 Kante scharf machen</translation>
    </message>
    <message>
        <source>Sharpen %1 edges</source>
        <translation>%1 Kanten scharf machen</translation>
    </message>
    <message>
        <source>Crease 1 edge</source>
        <translation>Schärfe von 1 Kante</translation>
    </message>
    <message>
        <source>Crease %1 edges</source>
        <translation>Schärfe von %1 Kanten</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>Glatte Fläche</translation>
    </message>
    <message>
        <source>Surface off</source>
        <translation>Glatte Fläche aus</translation>
    </message>
    <message>
        <source>Map 1 stroke</source>
        <translation>1 Strich projizieren</translation>
    </message>
    <message>
        <source>Map %1 strokes</source>
        <translation>%1 Striche projizieren</translation>
    </message>
    <message>
        <source>Remove strokes from surface</source>
        <translation>Striche von Oberfläche entfernen</translation>
    </message>
    <message>
        <source>Change template “%1”</source>
        <translation>Vorlage „%1“ ändern</translation>
    </message>
</context>
<context>
    <name>ew::EditActions</name>
    <message>
        <source>Pu&amp;ll faces</source>
        <translation>&amp;Flächen ziehen</translation>
    </message>
    <message>
        <source>Drag a face out of the solid or into it, or type how far</source>
        <translation>Eine Fläche aus dem Körper heraus- oder hineinziehen, oder eintippen, wie weit</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Clear ink</source>
        <translation>&amp;Striche verwerfen</translation>
    </message>
    <message>
        <source>&amp;Delete solid</source>
        <translation>Körper &amp;löschen</translation>
    </message>
    <message>
        <source>Drop all strokes that are no solid yet</source>
        <translation>Alle Striche verwerfen, die noch kein Körper sind</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation>S&amp;tift</translation>
    </message>
    <message>
        <source>Draw strokes</source>
        <translation>Striche zeichnen</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>Radi&amp;ergummi</translation>
    </message>
    <message>
        <source>Remove strokes; the eraser end of the pen does it too</source>
        <translation>Striche entfernen; das kann auch das Radierende des Stifts</translation>
    </message>
    <message>
        <source>&amp;Orbit</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>Turn the view; so do the right and the middle mouse button</source>
        <translation>Die Ansicht drehen; das können auch die rechte und die mittlere Maustaste</translation>
    </message>
    <message>
        <source>&amp;Move view</source>
        <translation>Ansicht &amp;verschieben</translation>
    </message>
    <message>
        <source>Move the view; so do Space with the left button and Shift with the middle one</source>
        <translation>Die Ansicht verschieben; das kann auch die Leertaste mit der linken und die Umschalttaste mit der mittleren Maustaste</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Undo stroke</source>
        <translation>Strich &amp;rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Pic&amp;k edges</source>
        <translation>&amp;Kanten wählen</translation>
    </message>
    <message>
        <source>Choose edges for a fillet; Shift adds</source>
        <translation>Kanten zum Verrunden wählen; die Umschalttaste nimmt weitere hinzu</translation>
    </message>
    <message>
        <source>Draw on the &amp;surface</source>
        <translation>Auf &amp;Oberfläche zeichnen</translation>
    </message>
    <message>
        <source>Every stroke goes straight onto the surface</source>
        <translation>Jeder Strich kommt gleich auf die Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Redo stroke</source>
        <translation>Strich &amp;wiederherstellen</translation>
    </message>
</context>
<context>
    <name>ew::ExportDialog</name>
    <message>
        <source>millimetres (mm)</source>
        <translation>Millimetern (mm)</translation>
    </message>
    <message>
        <source>centimetres (cm)</source>
        <translation>Zentimetern (cm)</translation>
    </message>
    <message>
        <source>metres (m)</source>
        <translation>Metern (m)</translation>
    </message>
    <message>
        <source>inches (in)</source>
        <translation>Zoll (in)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>This kind of file does not say what its numbers are. &amp;Lengths are written in:</source>
        <translation>Diese Art von Datei sagt nicht, was ihre Zahlen bedeuten. &amp;Längen werden geschrieben in:</translation>
    </message>
    <message>
        <source>It is used from now on, and can be changed by File, Export unit.</source>
        <translation>Das gilt von nun an und kann mit „Datei, Export-Einheit“ geändert werden.</translation>
    </message>
    <message>
        <source>&amp;Bodies:</source>
        <translation>&amp;Körper:</translation>
    </message>
</context>
<context>
    <name>ew::FileActions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>New document</source>
        <translation>Neues Dokument</translation>
    </message>
    <message>
        <source>Open a document or a sketch script</source>
        <translation>Ein Dokument oder ein Zeichenskript öffnen</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Das Dokument speichern</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to this document?</source>
        <translation>Die Änderungen an diesem Dokument speichern?</translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>Open e&amp;xample</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save what was done as a s&amp;cript…</source>
        <translation>Schritte als S&amp;kript speichern …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>There are no examples</source>
        <translation>Es gibt keine Beispiele</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Documents and sketch scripts (*.edgewright *.json);;All files (*)</source>
        <translation>Dokumente und Zeichenskripte (*.edgewright *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Step %1 of the script (%2): %3</source>
        <translation>Schritt %1 des Skripts (%2): %3</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Edgewright document (*.edgewright)</source>
        <translation>Edgewright-Dokument (*.edgewright)</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>Save what was done as a script</source>
        <translation>Schritte als Skript speichern</translation>
    </message>
    <message>
        <source>Sketch script (*.json)</source>
        <translation>Zeichenskript (*.json)</translation>
    </message>
    <message>
        <source>Script saved to %1.</source>
        <translation>Skript gespeichert in %1.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportiert nach %1.</translation>
    </message>
    <message>
        <source>Screenshot</source>
        <translation>Bildschirmfoto</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Picture saved to %1.</source>
        <translation>Bild gespeichert in %1.</translation>
    </message>
    <message>
        <source>Export the surface, cage or solid as OBJ, STL, PLY, glTF or 3MF</source>
        <translation>Fläche, Kontrollnetz oder Körper als OBJ, STL, PLY, glTF oder 3MF exportieren</translation>
    </message>
    <message>
        <source>Wavefront OBJ (*.obj);;STL, binary (*.stl);;PLY (*.ply);;glTF, binary (*.glb);;3MF (*.3mf)</source>
        <translation>Wavefront OBJ (*.obj);;STL, binär (*.stl);;PLY (*.ply);;glTF, binär (*.glb);;3MF (*.3mf)</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>Datei ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program since it was opened or saved here. Replacing it loses these changes.</source>
        <translation>%1 wurde von einem anderen Fenster oder Programm geändert, seit die Datei hier geöffnet oder gespeichert wurde. Beim Ersetzen gehen diese Änderungen verloren.</translation>
    </message>
    <message>
        <source>Not saved; “Save as” keeps both.</source>
        <translation>Nicht gespeichert; „Speichern unter“ erhält beide.</translation>
    </message>
    <message>
        <source>Opening writes no file and opens no other; steps left out: %1.</source>
        <translation>Öffnen schreibt keine Datei und öffnet keine andere; ausgelassene Schritte: %1.</translation>
    </message>
    <message>
        <source>Wavefront OBJ, triangles only (*.obj)</source>
        <translation>Wavefront OBJ, nur Dreiecke (*.obj)</translation>
    </message>
    <message>
        <source>Wavefront OBJ, whole faces (*.obj)</source>
        <translation>Wavefront OBJ, ganze Flächen (*.obj)</translation>
    </message>
    <message>
        <source>Re&amp;vert to the saved file</source>
        <translation>&amp;Zurück zur gespeicherten Datei</translation>
    </message>
    <message>
        <source>&amp;Recover…</source>
        <translation>&amp;Wiederherstellen …</translation>
    </message>
    <message>
        <source>Save a cop&amp;y…</source>
        <translation>Kop&amp;ie speichern …</translation>
    </message>
    <message>
        <source>%1 was not opened.</source>
        <translation>%1 wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>%1 was written by a later version and may hold more than is shown here; changes are saved under another name.</source>
        <translation>%1 stammt von einer neueren Version und enthält vielleicht mehr, als hier zu sehen ist; Änderungen werden unter einem anderen Namen gespeichert.</translation>
    </message>
    <message>
        <source>%1 is open in another window, too: %2.</source>
        <translation>%1 ist auch in einem anderen Fenster offen: %2.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>A copy was saved to %1.</source>
        <translation>Eine Kopie wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Everything that was done since %1 was saved is taken back.</source>
        <translation>Alles, was geschah, seit %1 gespeichert wurde, wird zurückgenommen.</translation>
    </message>
    <message>
        <source>Reverted to %1.</source>
        <translation>Zurück auf dem Stand von %1.</translation>
    </message>
    <message>
        <source>Without saving they are in no file, but File, Recover… offers them for a while.</source>
        <translation>Ungespeichert stehen sie in keiner Datei, aber „Datei, Wiederherstellen …“ bietet sie noch eine Weile an.</translation>
    </message>
    <message>
        <source>Revert to the saved file?</source>
        <translation>Zur gespeicherten Datei zurück?</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Screensho&amp;t…</source>
        <translation>Bildschirmf&amp;oto …</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Neues Fenste&amp;r</translation>
    </message>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>S&amp;tartseite</translation>
    </message>
    <message>
        <source>Export &amp;unit…</source>
        <translation>Export-Ein&amp;heit …</translation>
    </message>
    <message>
        <source>The export was given up; no file was written.</source>
        <translation>Der Export wurde abgebrochen; keine Datei wurde geschrieben.</translation>
    </message>
    <message>
        <source>Exported to %1, lengths in %2.</source>
        <translation>Nach %1 exportiert, Längen in %2.</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (schreibgeschützt)</translation>
    </message>
    <message>
        <source>This is a pupil’s work to look at. What is changed here can be saved under another name; the pupil’s file stays as it is.</source>
        <translation>Das ist die Arbeit eines Schülers zum Ansehen. Was hier geändert wird, lässt sich unter anderem Namen speichern; die Datei des Schülers bleibt, wie sie ist.</translation>
    </message>
</context>
<context>
    <name>ew::GraphPanel</name>
    <message numerus="yes">
        <source>outline on %n face(s)</source>
        <translation>
            <numerusform>Umriss auf %n Fläche</numerusform>
            <numerusform>Umriss auf %n Flächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>seen through %n face(s)</source>
        <translation>
            <numerusform>durch %n Fläche gesehen</numerusform>
            <numerusform>durch %n Flächen gesehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) seen</source>
        <translation>
            <numerusform>%n Fläche sichtbar</numerusform>
            <numerusform>%n Flächen sichtbar</numerusform>
        </translation>
    </message>
    <message>
        <source>drawing as a whole</source>
        <translation>Zeichnung im Ganzen</translation>
    </message>
    <message>
        <source>%1, fit %2 %, off by %3 px</source>
        <translation>%1, Passung %2 %, ±%3 px</translation>
    </message>
    <message>
        <source>Nearest: %1</source>
        <translation>Am nächsten: %1</translation>
    </message>
    <message>
        <source>%1 missing, %2 too many</source>
        <translation>%1 fehlen, %2 zu viel</translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation>Noch keine Vorlage</translation>
    </message>
    <message>
        <source>Nothing read yet</source>
        <translation>Noch nichts gelesen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s)</source>
        <translation>
            <numerusform>%n Kante</numerusform>
            <numerusform>%n Kanten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n junction(s)</source>
        <translation>
            <numerusform>%n Knoten</numerusform>
            <numerusform>%n Knoten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Every line is there, %n end(s) open</source>
        <translation>
            <numerusform>Alle Linien da, %n Ende offen</numerusform>
            <numerusform>Alle Linien da, %n Enden offen</numerusform>
        </translation>
    </message>
    <message>
        <source>As many lines, which meet in another way</source>
        <translation>Gleich viele Linien, die anders zusammentreffen</translation>
    </message>
</context>
<context>
    <name>ew::GraphView</name>
    <message>
        <source>Edge Graph</source>
        <translation>Kantengraph</translation>
    </message>
    <message>
        <source>Lines and corners appear here while you draw.</source>
        <translation>Linien und Ecken erscheinen hier beim Zeichnen.</translation>
    </message>
</context>
<context>
    <name>ew::HistoryModel</name>
    <message>
        <source>Empty document</source>
        <translation>Leeres Dokument</translation>
    </message>
</context>
<context>
    <name>ew::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Name…</source>
        <translation>Benennen …</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>Take the change back</source>
        <translation>Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Gives this state a name (F2).</source>
        <translation>Gibt diesem Stand einen Namen (F2).</translation>
    </message>
    <message>
        <source>Changes the step that made this state, and does again what follows.</source>
        <translation>Ändert den Schritt, der zu diesem Stand führte, und führt erneut aus, was folgt.</translation>
    </message>
    <message>
        <source>Brings back the history as it was before a step was changed.</source>
        <translation>Stellt den Verlauf wieder her, wie er war, bevor ein Schritt geändert wurde.</translation>
    </message>
    <message>
        <source>&amp;Go there</source>
        <translation>Dorthin &amp;gehen</translation>
    </message>
    <message>
        <source>&amp;Change the step…</source>
        <translation>Den Schritt än&amp;dern …</translation>
    </message>
    <message>
        <source>Co&amp;mpact the history…</source>
        <translation>Den Verlauf &amp;verdichten …</translation>
    </message>
    <message>
        <source>Name of the state</source>
        <translation>Name des Standes</translation>
    </message>
    <message>
        <source>Name of the state after “%1”; empty: none.</source>
        <translation>Name des Standes nach „%1“; leer: keiner.</translation>
    </message>
    <message>
        <source>This step has nothing that could be changed.</source>
        <translation>An diesem Schritt gibt es nichts zu ändern.</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>Doing again what follows…</source>
        <translation>Was folgt, wird erneut ausgeführt …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>Step %1 was changed, and %n step(s) after it done again.</source>
        <translation>
            <numerusform>Schritt %1 wurde geändert und %n Schritt danach erneut ausgeführt.</numerusform>
            <numerusform>Schritt %1 wurde geändert und %n Schritte danach erneut ausgeführt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2: %3</source>
        <translation>%1. %2: %3</translation>
    </message>
    <message>
        <source>Some steps no longer fit</source>
        <translation>Einige Schritte passen nicht mehr</translation>
    </message>
    <message numerus="yes">
        <source>Step %1 was changed. %n step(s) after it no longer fit and were left out; the strokes that they had used are kept.</source>
        <translation>
            <numerusform>Schritt %1 wurde geändert. %n Schritt danach passt nicht mehr und wurde ausgelassen; die Striche, die er verwendet hatte, sind noch da.</numerusform>
            <numerusform>Schritt %1 wurde geändert. %n Schritte danach passen nicht mehr und wurden ausgelassen; die Striche, die sie verwendet hatten, sind noch da.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Compact the history</source>
        <translation>Den Verlauf verdichten</translation>
    </message>
    <message>
        <source>Merge the steps between named states?</source>
        <translation>Die Schritte zwischen benannten Ständen zusammenfassen?</translation>
    </message>
    <message>
        <source>Only named states and the one of now stay to go back to; steps that were undone go. The drawing stays as it is, and the file gets smaller.</source>
        <translation>Zurück geht es dann nur noch zu benannten Ständen und zum jetzigen; zurückgenommene Schritte fallen weg. Die Zeichnung bleibt, wie sie ist, und die Datei wird kleiner.</translation>
    </message>
    <message>
        <source>&amp;Compact</source>
        <translation>&amp;Verdichten</translation>
    </message>
</context>
<context>
    <name>ew::JoinDialog</name>
    <message>
        <source>Work in a class</source>
        <translation>In einer Klasse arbeiten</translation>
    </message>
    <message>
        <source>What you do in lessons is kept in the class folder under your name, for your teacher to see. There is no account and no password.</source>
        <translation>Was du in Lektionen machst, wird unter deinem Namen im Klassenordner gesichert, sodass deine Lehrkraft es sieht. Ein Konto oder Passwort gibt es nicht.</translation>
    </message>
    <message>
        <source>A share, or a folder on a stick</source>
        <translation>Eine Freigabe oder ein Ordner auf einem Stick</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen …</translation>
    </message>
    <message>
        <source>Class &amp;folder:</source>
        <translation>Klassen&amp;ordner:</translation>
    </message>
    <message>
        <source>First name, or as your teacher says</source>
        <translation>Vorname, oder wie ihr es vereinbart habt</translation>
    </message>
    <message>
        <source>Your &amp;name:</source>
        <translation>Dein &amp;Name:</translation>
    </message>
    <message>
        <source>&amp;Work here</source>
        <translation>Hier &amp;arbeiten</translation>
    </message>
    <message>
        <source>Class folder</source>
        <translation>Klassenordner</translation>
    </message>
</context>
<context>
    <name>ew::LessonActions</name>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>%1 (%2 min)</source>
        <translation>%1 (%2 min)</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>Lektion ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (%1)</source>
        <translation>Lektionen (%1)</translation>
    </message>
</context>
<context>
    <name>ew::LessonDock</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
</context>
<context>
    <name>ew::LessonPanel</name>
    <message>
        <source>Hint</source>
        <translation>Tipp</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Zeig es mir</translation>
    </message>
    <message>
        <source>A pen draws the lines for you to follow.</source>
        <translation>Ein Stift zeichnet die Linien vor.</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Begins this step again.</source>
        <translation>Beginnt diesen Schritt noch einmal.</translation>
    </message>
    <message>
        <source>End the lesson</source>
        <translation>Lektion beenden</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Done. %1</source>
        <translation>Geschafft. %1</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1: not kept in the class folder yet</source>
        <translation>%1: noch nicht im Klassenordner gesichert</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>End the exercise</source>
        <translation>Übung beenden</translation>
    </message>
</context>
<context>
    <name>ew::LongJob</name>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 wird exportiert …</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ew::MainWindow</name>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Sketch</source>
        <translation>&amp;Zeichnung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Quick help</source>
        <translation>&amp;Kurzhilfe</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About Edgewright</source>
        <translation>Ü&amp;ber Edgewright</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>Edge Graph</source>
        <translation>Kantengraph</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lesarten</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>T-LIB</source>
        <translation>T-LIB</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (schreibgeschützt)</translation>
    </message>
    <message>
        <source>%1[*] – Edgewright</source>
        <translation>%1[*] – Edgewright</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
</context>
<context>
    <name>ew::MessageBar</name>
    <message>
        <source>Cut the solid in two.</source>
        <translation>Der Körper ist geteilt.</translation>
    </message>
    <message>
        <source>Enter cuts the solid in two.</source>
        <translation>Enter teilt den Körper.</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Draw the next shape.</source>
        <translation>Die nächste Form zeichnen.</translation>
    </message>
    <message>
        <source>Draw the edges that you would see of a box, a prism or a pyramid, in any order and with any number of strokes.</source>
        <translation>Die sichtbaren Kanten eines Quaders, eines Prismas oder einer Pyramide zeichnen, in beliebiger Reihenfolge und mit beliebig vielen Strichen.</translation>
    </message>
    <message numerus="yes">
        <source>%n other reading(s): keys 1 to 9.</source>
        <translation>
            <numerusform>%n andere Lesart: Tasten 1 bis 9.</numerusform>
            <numerusform>%n andere Lesarten: Tasten 1 bis 9.</numerusform>
        </translation>
    </message>
    <message>
        <source>Enter adds it to the solid.</source>
        <translation>Die Eingabetaste fügt es dem Körper hinzu.</translation>
    </message>
    <message>
        <source>Enter cuts it out of the solid.</source>
        <translation>Die Eingabetaste zieht es vom Körper ab.</translation>
    </message>
    <message>
        <source>Enter makes it a solid.</source>
        <translation>Die Eingabetaste macht es zum Körper.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Clear: %1. Applying it; Escape waits.</source>
        <translation>Eindeutig: %1. Wird angewendet; Escape hält es auf.</translation>
    </message>
    <message>
        <source>Clear: %1. %2</source>
        <translation>Eindeutig: %1. %2</translation>
    </message>
    <message>
        <source>Chosen: %1. %2</source>
        <translation>Gewählt: %1. %2</translation>
    </message>
    <message>
        <source>Reading the drawing…</source>
        <translation>Die Zeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>Keep drawing.</source>
        <translation>Weiterzeichnen.</translation>
    </message>
    <message>
        <source>Added %1.</source>
        <translation>%1 hinzugefügt.</translation>
    </message>
    <message>
        <source>Cut %1.</source>
        <translation>%1 abgezogen.</translation>
    </message>
    <message>
        <source>Made %1.</source>
        <translation>%1 erzeugt.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that it does not use stay.</source>
        <translation>
            <numerusform>%n Strich, der nicht dazugehört, bleibt.</numerusform>
            <numerusform>%n Striche, die nicht dazugehören, bleiben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::MirrorActions</name>
    <message>
        <source>&amp;No mirror plane</source>
        <translation>&amp;Keine Spiegelebene</translation>
    </message>
    <message>
        <source>Left and right, across &amp;X</source>
        <translation>Links und rechts, quer zu &amp;X</translation>
    </message>
    <message>
        <source>Front and back, across &amp;Y</source>
        <translation>Vorn und hinten, quer zu &amp;Y</translation>
    </message>
    <message>
        <source>Above and below, across &amp;Z</source>
        <translation>Oben und unten, quer zu &amp;Z</translation>
    </message>
    <message>
        <source>What you draw, pull and round from now on is done on both sides of the plane through the middle of the chosen solids</source>
        <translation>Was ab jetzt gezeichnet, gezogen und gerundet wird, geschieht auf beiden Seiten der Ebene durch die Mitte der gewählten Körper</translation>
    </message>
    <message>
        <source>No mirror plane: what you draw is done once.</source>
        <translation>Keine Spiegelebene: Was gezeichnet wird, geschieht einmal.</translation>
    </message>
    <message>
        <source>Mirror plane set: what you draw, pull and round is done on both sides.</source>
        <translation>Spiegelebene gesetzt: Was gezeichnet, gezogen und gerundet wird, geschieht auf beiden Seiten.</translation>
    </message>
    <message>
        <source>Mirror &amp;plane</source>
        <translation>Spiegel&amp;ebene</translation>
    </message>
</context>
<context>
    <name>ew::MoveDialog</name>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Keep the solid and move a &amp;copy</source>
        <translation>Den Körper behalten und eine &amp;Kopie bewegen</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>„%1“ bewegen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Along %1</source>
        <translation>Entlang %1</translation>
    </message>
    <message>
        <source>Along &amp;%1</source>
        <translation>Entlang &amp;%1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>um %1</translation>
    </message>
    <message>
        <source>across %1</source>
        <translation>quer zu %1</translation>
    </message>
    <message>
        <source>not</source>
        <translation>nicht</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>&amp;Scale to</source>
        <translation>&amp;Skalieren auf</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>S&amp;piegeln</translation>
    </message>
    <message>
        <source>It is scaled, turned and mirrored about its middle, then moved.</source>
        <translation>Er wird um seine Mitte skaliert, gedreht und gespiegelt, dann bewegt.</translation>
    </message>
    <message>
        <source>M&amp;ove</source>
        <translation>&amp;Bewegen</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>ew::NumberBox</name>
    <message>
        <source>“%1” is not between %2 and %3; the old number stays.</source>
        <translation>„%1“ liegt nicht zwischen %2 und %3; die alte Zahl bleibt.</translation>
    </message>
    <message>
        <source>“%1” is not a number; the old one stays.</source>
        <translation>„%1“ ist keine Zahl; die alte bleibt.</translation>
    </message>
</context>
<context>
    <name>ew::OverviewDialog</name>
    <message>
        <source>Class overview</source>
        <translation>Klassenübersicht</translation>
    </message>
    <message>
        <source>Pupils and lessons</source>
        <translation>Schüler und Lektionen</translation>
    </message>
    <message>
        <source>Find a pupil</source>
        <translation>Schüler suchen</translation>
    </message>
    <message>
        <source>Only who is &amp;stuck</source>
        <translation>Nur wer fest&amp;hängt</translation>
    </message>
    <message>
        <source>&amp;Open the work</source>
        <translation>Arbeit ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>A&amp;ktualisieren</translation>
    </message>
    <message>
        <source>Another &amp;class…</source>
        <translation>Andere K&amp;lasse …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Shows the chosen work in the window. The pupil&apos;s file stays as it is.</source>
        <translation>Zeigt die gewählte Arbeit im Fenster. Die Datei des Schülers bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Writes the page as CSV or HTML.</source>
        <translation>Schreibt die Seite als CSV oder HTML.</translation>
    </message>
    <message>
        <source>Nobody has worked here yet.</source>
        <translation>Hier hat noch niemand gearbeitet.</translation>
    </message>
    <message numerus="yes">
        <source>%n pupil(s)</source>
        <translation>
            <numerusform>%n Schüler</numerusform>
            <numerusform>%n Schüler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <translation>
            <numerusform>%n hängt fest</numerusform>
            <numerusform>%n hängen fest</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, as of %2</source>
        <translation>%1, Stand %2</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) cannot be read.</source>
        <translation>
            <numerusform>%n weitere Datei ist nicht lesbar.</numerusform>
            <numerusform>%n weitere Dateien sind nicht lesbar.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has begun no lesson yet.</source>
        <translation>%1 hat noch keine Lektion begonnen.</translation>
    </message>
    <message>
        <source>%1 has no work in “%2” yet.</source>
        <translation>%1 hat in „%2“ noch keine Arbeit.</translation>
    </message>
    <message>
        <source>%1, “%2”</source>
        <translation>%1, „%2“</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Class folder</source>
        <translation>Klassenordner</translation>
    </message>
    <message>
        <source>Export the overview</source>
        <translation>Übersicht exportieren</translation>
    </message>
    <message>
        <source>Page for any browser (*.html);;Table for spreadsheets (*.csv)</source>
        <translation>Seite für jeden Browser (*.html);;Tabelle für Tabellenkalkulationen (*.csv)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>ew::OverviewModel</name>
    <message>
        <source>%1 (from another machine)</source>
        <translation>%1 (von einem anderen Rechner)</translation>
    </message>
    <message>
        <source>%1
since %2</source>
        <translation>%1
seit %2</translation>
    </message>
</context>
<context>
    <name>ew::PracticeActions</name>
    <message>
        <source>&amp;Practice…</source>
        <translation>Ü&amp;ben …</translation>
    </message>
</context>
<context>
    <name>ew::PracticeCurve</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Accuracy %1, pen down for %2, lines off straight by %3.</source>
        <translation>Genauigkeit %1, Stift unten %2, Linien um %3 krumm.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Wobble</source>
        <translation>Zittern</translation>
    </message>
    <message>
        <source>After the first exercise your accuracy, time and steadiness are shown here.</source>
        <translation>Nach der ersten Übung stehen hier deine Genauigkeit, deine Zeit und deine ruhige Hand.</translation>
    </message>
</context>
<context>
    <name>ew::PracticeDialog</name>
    <message>
        <source>Boxes</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Prisms, pyramids, frusta</source>
        <translation>Prismen, Pyramiden, Stümpfe</translation>
    </message>
    <message>
        <source>Houses, angles, columns</source>
        <translation>Häuser, Winkel, Säulen</translation>
    </message>
    <message>
        <source>Stairs, channels, T-beams</source>
        <translation>Treppen, Rinnen, T-Träger</translation>
    </message>
    <message>
        <source>Boxes on boxes</source>
        <translation>Quader auf Quadern</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Draw a solid that is shown as it is to be drawn, or from three sides. A number is the same solid for everybody in a class.</source>
        <translation>Zeichne einen Körper, der so gezeigt wird, wie er zu zeichnen ist, oder von drei Seiten. Eine Nummer ist für alle in einer Klasse derselbe Körper.</translation>
    </message>
    <message>
        <source>&amp;Any number</source>
        <translation>&amp;Irgendeine</translation>
    </message>
    <message>
        <source>&amp;Level:</source>
        <translation>&amp;Stufe:</translation>
    </message>
    <message>
        <source>&amp;Number:</source>
        <translation>&amp;Nummer:</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ew::PullBar</name>
    <message>
        <source>Straight walls</source>
        <translation>Gerade Wände</translation>
    </message>
    <message>
        <source>Pull by</source>
        <translation>Ziehen um</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance to pull the face by</source>
        <translation>Strecke, um die die Fläche gezogen wird</translation>
    </message>
    <message>
        <source>The face keeps its outline, and new walls join it to the solid. Without it, the faces beside it go on as they slant.</source>
        <translation>Die Fläche behält ihren Umriss, und neue Wände verbinden sie mit dem Körper. Sonst laufen die Nachbarflächen so weiter, wie sie geneigt sind.</translation>
    </message>
    <message>
        <source>Type another distance and press Enter; negative goes inwards.</source>
        <translation>Eine andere Strecke eintippen und Enter drücken; negativ geht nach innen.</translation>
    </message>
    <message>
        <source>Drag a face, or click one and type a distance.</source>
        <translation>Eine Fläche ziehen, oder eine anklicken und eine Strecke eintippen.</translation>
    </message>
</context>
<context>
    <name>ew::RecentActions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>%1 (not found)</source>
        <translation>%1 (nicht gefunden)</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Noch wurde nichts geöffnet</translation>
    </message>
</context>
<context>
    <name>ew::RecoverDialog</name>
    <message>
        <source>Recover documents</source>
        <translation>Dokumente wiederherstellen</translation>
    </message>
    <message>
        <source>These documents were kept while they were being worked on. What is put away stays for 30 days.</source>
        <translation>Diese Dokumente wurden aufbewahrt, während an ihnen gearbeitet wurde. Was weggelegt wird, bleibt noch 30 Tage.</translation>
    </message>
    <message>
        <source>Documents that can be recovered</source>
        <translation>Dokumente, die sich wiederherstellen lassen</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) waiting</source>
        <translation>
            <numerusform>%n wartender Strich</numerusform>
            <numerusform>%n wartende Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Put away</source>
        <translation>Weg&amp;legen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
</context>
<context>
    <name>ew::SketchActions</name>
    <message>
        <source>Set new solids &amp;level</source>
        <translation>Neue Körper auf&amp;richten</translation>
    </message>
    <message>
        <source>A new solid that leans by no more than the angle threshold is turned upright and stands on the ground</source>
        <translation>Ein neuer Körper, der um höchstens die Winkelschwelle schief steht, wird aufgerichtet und steht auf dem Boden</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>Apply by &amp;itself when clear</source>
        <translation>Eindeutiges von &amp;selbst anwenden</translation>
    </message>
    <message>
        <source>Make a solid of the drawing (Enter)</source>
        <translation>Aus der Zeichnung einen Körper machen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Make a solid without asking when one reading is clearly the best (A)</source>
        <translation>Ohne Rückfrage einen Körper machen, wenn eine Lesart eindeutig die beste ist (A)</translation>
    </message>
    <message>
        <source>Reading &amp;%1</source>
        <translation>Lesart &amp;%1</translation>
    </message>
    <message>
        <source>Reading &amp;%1: %2</source>
        <translation>Lesart &amp;%1: %2</translation>
    </message>
    <message>
        <source>Reading &amp;%1: %2, %3</source>
        <translation>Lesart &amp;%1: %2, %3</translation>
    </message>
    <message>
        <source>%1 can be drawn from now on.</source>
        <translation>%1 kann von jetzt an gezeichnet werden.</translation>
    </message>
    <message>
        <source>&amp;Template editor…</source>
        <translation>&amp;Vorlageneditor …</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Kopie von %1</translation>
    </message>
</context>
<context>
    <name>ew::StartPage</name>
    <message>
        <source>&amp;New drawing</source>
        <translation>&amp;Neue Zeichnung</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>Was aufgelistet wird</translation>
    </message>
    <message>
        <source>Show this page at start</source>
        <translation>Beim Start diese Seite zeigen</translation>
    </message>
    <message>
        <source>Search name or folder</source>
        <translation>Name oder Ordner suchen</translation>
    </message>
    <message>
        <source>Recent documents</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recover (%1)</source>
        <translation>Wiederherstellen (%1)</translation>
    </message>
    <message>
        <source>Drawings that are replayed stroke by stroke; the history shows how each was made.</source>
        <translation>Zeichnungen, die Strich für Strich abgespielt werden; der Verlauf zeigt, wie jede entstand.</translation>
    </message>
    <message>
        <source>Work that was not closed</source>
        <translation>Nicht geschlossene Arbeit</translation>
    </message>
    <message>
        <source>The program ended while these were open. They are whole up to the last finished stroke.</source>
        <translation>Das Programm endete, während dies geöffnet war. Alles ist vollständig bis zum letzten beendeten Strich.</translation>
    </message>
    <message>
        <source>Not found: %1</source>
        <translation>Nicht gefunden: %1</translation>
    </message>
    <message>
        <source>Used last: %1</source>
        <translation>Zuletzt verwendet: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>It has no file yet.</source>
        <translation>Es gibt noch keine Datei.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) waiting</source>
        <translation>
            <numerusform>%n Strich wartet</numerusform>
            <numerusform>%n Striche warten</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing here is called “%1”.</source>
        <translation>Hier heißt nichts „%1“.</translation>
    </message>
    <message>
        <source>What you open or save is listed here.</source>
        <translation>Was Sie öffnen oder speichern, steht dann hier.</translation>
    </message>
    <message>
        <source>There are no examples</source>
        <translation>Es gibt keine Beispiele</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Open in a new &amp;window</source>
        <translation>In einem neuen F&amp;enster öffnen</translation>
    </message>
    <message>
        <source>Un&amp;pin</source>
        <translation>&amp;Lösen</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Anheften</translation>
    </message>
    <message>
        <source>Open its &amp;folder</source>
        <translation>Den &amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>&amp;Remove from the list</source>
        <translation>Aus der Liste en&amp;tfernen</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Put away</source>
        <translation>Weg&amp;legen</translation>
    </message>
    <message>
        <source>It stays for 30 days: File, Recover.</source>
        <translation>Es bleibt 30 Tage: Datei, Wiederherstellen.</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Each leads through something that can be drawn, step by step, with strokes to trace and hints.</source>
        <translation>Jede führt Schritt für Schritt durch etwas, das man zeichnen kann, mit Strichen zum Nachziehen und Hinweisen.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>There are no lessons</source>
        <translation>Es gibt keine Lektionen</translation>
    </message>
</context>
<context>
    <name>ew::StepDialog</name>
    <message>
        <source>What follows is done again. Steps that no longer fit are named, and their strokes are kept.</source>
        <translation>Was folgt, wird erneut ausgeführt. Schritte, die nicht mehr passen, werden genannt, und ihre Striche bleiben.</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>Än&amp;dern</translation>
    </message>
    <message>
        <source>Distance:</source>
        <translation>Abstand:</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Angle:</source>
        <translation>Winkel:</translation>
    </message>
    <message>
        <source>Oblique factor:</source>
        <translation>Schrägfaktor:</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lesarten</translation>
    </message>
    <message>
        <source>Radius:</source>
        <translation>Radius:</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Segments:</source>
        <translation>Segmente:</translation>
    </message>
    <message>
        <source>Sharpness:</source>
        <translation>Schärfe:</translation>
    </message>
    <message>
        <source>Tolerance:</source>
        <translation>Toleranz:</translation>
    </message>
    <message>
        <source>Levels:</source>
        <translation>Stufen:</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>fit %1 %</source>
        <translation>Passung %1 %</translation>
    </message>
</context>
<context>
    <name>ew::SurfaceActions</name>
    <message>
        <source>&amp;Fillet the chosen edges</source>
        <translation>Gewählte Kanten &amp;verrunden</translation>
    </message>
    <message>
        <source>Round the edges that the Surface panel names, with its radius</source>
        <translation>Die Kanten verrunden, die im Feld Oberfläche gewählt sind, mit dem Radius von dort</translation>
    </message>
    <message>
        <source>Make the chosen edges &amp;sharp</source>
        <translation>Gewählte Kanten &amp;scharf machen</translation>
    </message>
    <message>
        <source>Take their fillets away</source>
        <translation>Ihre Verrundungen entfernen</translation>
    </message>
    <message>
        <source>The smooth surface over the solid, on and off</source>
        <translation>Die glatte Fläche über dem Körper ein- und ausschalten</translation>
    </message>
    <message>
        <source>Show the &amp;cage</source>
        <translation>&amp;Kontrollnetz zeigen</translation>
    </message>
    <message>
        <source>The cage over the smooth surface</source>
        <translation>Das Kontrollnetz über der glatten Fläche</translation>
    </message>
    <message>
        <source>&amp;Map strokes onto the surface</source>
        <translation>Striche auf Oberfläche &amp;projizieren</translation>
    </message>
    <message>
        <source>Put what is drawn onto the surface</source>
        <translation>Die Zeichnung auf die Oberfläche bringen</translation>
    </message>
    <message>
        <source>&amp;Remove strokes from the surface</source>
        <translation>Striche von Oberfläche &amp;entfernen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Smoo&amp;th surface</source>
        <translation>&amp;Glatte Fläche</translation>
    </message>
</context>
<context>
    <name>ew::SurfaceController</name>
    <message>
        <source>1 edge is filleted.</source>
        <translation>1 Kante ist verrundet.</translation>
    </message>
    <message>
        <source>%1 edges are filleted.</source>
        <translation>%1 Kanten sind verrundet.</translation>
    </message>
    <message>
        <source>One edge has no room for its radius and got a smaller one.</source>
        <translation>Eine Kante hat keinen Platz für ihren Radius und bekam einen kleineren.</translation>
    </message>
    <message>
        <source>%1 edges have no room for their radius and got smaller ones; the Surface panel lists them.</source>
        <translation>%1 Kanten haben keinen Platz für ihren Radius und bekamen kleinere; das Feld Oberfläche nennt sie.</translation>
    </message>
    <message>
        <source>One stroke has no surface under it and stays as it is.</source>
        <translation>Ein Strich hat keine Oberfläche unter sich und bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>%1 strokes have no surface under them and stay as they are.</source>
        <translation>%1 Striche haben keine Oberfläche unter sich und bleiben, wie sie sind.</translation>
    </message>
</context>
<context>
    <name>ew::SurfacePanel</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Fillet</source>
        <translation>Verrunden</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>konvexe</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>konkave</translation>
    </message>
    <message>
        <source>picked</source>
        <translation>angeklickte</translation>
    </message>
    <message>
        <source>Which edges are meant. Picked edges are clicked in the drawing.</source>
        <translation>Welche Kanten gemeint sind. Angeklickt wird in der Zeichnung.</translation>
    </message>
    <message>
        <source>one edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>a loop of edges</source>
        <translation>Kantenschleife</translation>
    </message>
    <message>
        <source>all edges of a face</source>
        <translation>Kanten einer Fläche</translation>
    </message>
    <message>
        <source>What a click picks. Shift adds to what is picked, or takes it out.</source>
        <translation>Was ein Klick wählt. Mit der Umschalttaste kommt es hinzu oder wird herausgenommen.</translation>
    </message>
    <message>
        <source>A &amp;click picks</source>
        <translation>Kli&amp;ck wählt</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Edges without room for their radius</source>
        <translation>Kanten ohne Platz für ihren Radius</translation>
    </message>
    <message>
        <source>Edges without room for their radius, and what is in the way. A click marks the edge.</source>
        <translation>Kanten ohne Platz für ihren Radius, und was im Weg ist. Ein Klick markiert die Kante.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Flat pieces across a fillet: 1 is a chamfer, more are rounder. A smooth surface is round with one or two.</source>
        <translation>Ebene Streifen quer zur Verrundung: 1 ist eine Fase, mehr sind runder. Eine glatte Fläche ist schon mit einem oder zweien rund.</translation>
    </message>
    <message>
        <source>Radius of the fillet. Dragging shows it; letting go makes it a step. Where a radius does not fit, that edge alone gets a smaller one.</source>
        <translation>Radius der Verrundung. Ziehen zeigt ihn, Loslassen macht daraus einen Schritt. Wo ein Radius nicht passt, bekommt nur diese Kante einen kleineren.</translation>
    </message>
    <message>
        <source>&amp;Radius</source>
        <translation>&amp;Radius</translation>
    </message>
    <message>
        <source>click an edge in the drawing</source>
        <translation>Kante in der Zeichnung anklicken</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 Kante</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>Glatte Fläche</translation>
    </message>
    <message>
        <source>Catmull-Clark</source>
        <translation>Catmull-Clark</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Loop</translation>
    </message>
    <message>
        <source>Catmull-Clark works on the faces as they are, Loop on triangles.</source>
        <translation>Catmull-Clark nimmt die Flächen, wie sie sind, Loop nimmt Dreiecke.</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>tolerance (adaptive)</source>
        <translation>Toleranz (adaptiv)</translation>
    </message>
    <message>
        <source>Levels split every face alike. A tolerance spends triangles where the surface is curved.</source>
        <translation>Stufen teilen jede Fläche gleich fein. Eine Toleranz setzt Dreiecke dort, wo die Fläche gekrümmt ist.</translation>
    </message>
    <message>
        <source>No point of the surface is farther than this from its triangles.</source>
        <translation>Kein Punkt der Fläche liegt weiter als das von ihren Dreiecken entfernt.</translation>
    </message>
    <message>
        <source>&amp;Levels</source>
        <translation>St&amp;ufen</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>A surface that would need more is refused.</source>
        <translation>Eine Fläche, die mehr bräuchte, wird abgelehnt.</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source>How sharp edges without a fillet stay: 0 is smooth, 10 is sharp for ever. Automatic: sharp where anything is filleted, else smooth.</source>
        <translation>Wie scharf Kanten ohne Verrundung bleiben: 0 ist glatt, 10 ist für immer scharf. Automatisch: scharf, sobald etwas verrundet ist, sonst glatt.</translation>
    </message>
    <message>
        <source>A sharpness of its own for the edges chosen above.</source>
        <translation>Eine eigene Schärfe für die oben gewählten Kanten.</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Chosen edges</source>
        <translation>Gewählte</translation>
    </message>
    <message>
        <source>Strokes on the surface</source>
        <translation>Striche auf der Oberfläche</translation>
    </message>
    <message>
        <source>Draw on it</source>
        <translation>Darauf zeichnen</translation>
    </message>
    <message>
        <source>Every stroke goes straight onto the surface (B)</source>
        <translation>Jeder Strich kommt gleich auf die Oberfläche (B)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the next strokes on the surface</source>
        <translation>Farbe der nächsten Striche auf der Oberfläche</translation>
    </message>
    <message>
        <source>Map drawing</source>
        <translation>Projizieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Colour of strokes</source>
        <translation>Farbe der Striche</translation>
    </message>
    <message>
        <source>Ed&amp;ges</source>
        <translation>Kant&amp;en</translation>
    </message>
    <message>
        <source>Seg&amp;ments</source>
        <translation>Se&amp;gmente</translation>
    </message>
    <message>
        <source>Smoo&amp;th surface over the solid</source>
        <translation>Glatte &amp;Fläche über dem Körper</translation>
    </message>
    <message>
        <source>Sho&amp;w the cage over it</source>
        <translation>Kontro&amp;llnetz zeigen</translation>
    </message>
    <message>
        <source>Scheme</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>&amp;Keep sharp corners in place</source>
        <translation>Scharfe Ecken am &amp;Platz halten</translation>
    </message>
    <message>
        <source>Sharp edges</source>
        <translation>Kantenschärfe</translation>
    </message>
</context>
<context>
    <name>ew::TemplatePanel</name>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Open template f&amp;older</source>
        <translation>Ordner der &amp;Vorlagen öffnen</translation>
    </message>
    <message>
        <source>A template file that is put there is used from the next start on.</source>
        <translation>Eine Vorlagendatei, die dort liegt, gilt vom nächsten Start an.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 faces</source>
        <translation>%1 Ecken, %2 Flächen</translation>
    </message>
    <message>
        <source>%1 parallel</source>
        <translation>%1 × parallel</translation>
    </message>
    <message>
        <source>%1 perpendicular</source>
        <translation>%1 × senkrecht</translation>
    </message>
    <message>
        <source>%1 equal length</source>
        <translation>%1 × gleich lang</translation>
    </message>
    <message>
        <source>No relations</source>
        <translation>Keine Beziehungen</translation>
    </message>
    <message>
        <source>Relations: %1</source>
        <translation>Beziehungen: %1</translation>
    </message>
    <message>
        <source>Also read as: %1</source>
        <translation>Auch gelesen als: %1</translation>
    </message>
    <message>
        <source>New tem&amp;plate…</source>
        <translation>Vorlage aufneh&amp;men …</translation>
    </message>
    <message>
        <source>The solid on screen, or a prism, pyramid or frustum, becomes a shape that drawings can match.</source>
        <translation>Der gezeigte Körper, ein Prisma, eine Pyramide oder ein Stumpf wird zu einer Form, auf die Zeichnungen passen können.</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten …</translation>
    </message>
    <message>
        <source>Only templates of this document can be changed; duplicate this one.</source>
        <translation>Nur Vorlagen dieses Dokuments lassen sich ändern; diese lässt sich duplizieren.</translation>
    </message>
    <message>
        <source>&amp;Duplicate…</source>
        <translation>&amp;Duplizieren …</translation>
    </message>
</context>
<context>
    <name>ew::ThresholdPanel</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>How far apart two stroke ends may be and still meet in one corner, and how far the eraser reaches. It is the ring round the pen tip.</source>
        <translation>Wie weit zwei Strichenden auseinanderliegen dürfen und sich doch in einer Ecke treffen, und wie weit der Radiergummi reicht. Es ist der Ring um die Stiftspitze.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How much two lines may differ in direction and still count as parallel.</source>
        <translation>Wie weit die Richtungen zweier Linien abweichen dürfen, damit sie noch als parallel gelten.</translation>
    </message>
    <message>
        <source>Distance from the drawing</source>
        <translation>Abstand aus der Zeichnung</translation>
    </message>
    <message>
        <source>The distance grows with a large drawing whose lines leave wide gaps. Setting it by hand ends this; a tick here brings it back.</source>
        <translation>Der Abstand wächst mit einer großen Zeichnung, deren Linien weite Lücken lassen. Wer ihn von Hand setzt, beendet das; ein Haken hier holt es zurück.</translation>
    </message>
    <message>
        <source>Distance from the drawing, angle back to %1°</source>
        <translation>Abstand aus der Zeichnung, Winkel zurück auf %1°</translation>
    </message>
    <message>
        <source>%1 threshold</source>
        <translation>Schwelle: %1</translation>
    </message>
    <message>
        <source>D&amp;istance</source>
        <translation>Absta&amp;nd</translation>
    </message>
    <message>
        <source>A&amp;ngle</source>
        <translation>W&amp;inkel</translation>
    </message>
</context>
<context>
    <name>ew::ViewActions</name>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>&amp;Hidden edges</source>
        <translation>&amp;Verdeckte Kanten</translation>
    </message>
    <message>
        <source>Soft shadows in corners; slow without a graphics card</source>
        <translation>Weiche Schatten in Ecken; langsam ohne Grafikkarte</translation>
    </message>
    <message>
        <source>Show &amp;reading</source>
        <translation>&amp;Lesart zeigen</translation>
    </message>
    <message>
        <source>&amp;Start view</source>
        <translation>&amp;Startansicht</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>Vor&amp;n</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>L&amp;inks</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>Re&amp;chts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Show everything (F)</source>
        <translation>Alles zeigen (F)</translation>
    </message>
    <message>
        <source>Hidden edges as dashes (D)</source>
        <translation>Verdeckte Kanten gestrichelt (D)</translation>
    </message>
    <message>
        <source>Show in the drawing what is read from it (R)</source>
        <translation>In der Zeichnung zeigen, was aus ihr gelesen wird (R)</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Soft shado&amp;ws</source>
        <translation>Weiche Scha&amp;tten</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>&amp;Darstellung</translation>
    </message>
</context>
<context>
    <name>ew::ViewportWidget</name>
    <message>
        <source>Drawing surface</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>Draw with the pen or the left mouse button. The middle or right button orbits.</source>
        <translation>Mit dem Stift oder der linken Maustaste zeichnen. Die mittlere oder rechte Maustaste dreht.</translation>
    </message>
</context>
<context>
    <name>ew::WholeNumberBox</name>
    <message>
        <source>“%1” is not a whole number; the old one stays.</source>
        <translation>„%1“ ist keine ganze Zahl; die alte bleibt.</translation>
    </message>
</context>
<context>
    <name>ew::WorkKeeper</name>
    <message>
        <source>What you do is not kept safe until it is saved: %1</source>
        <translation>Was Sie tun, ist erst sicher, wenn es gespeichert ist: %1</translation>
    </message>
    <message>
        <source>There is nothing to recover.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n step(s), as of %1.</source>
        <translation>
            <numerusform>Wiederhergestellt: %n Schritt, Stand %1.</numerusform>
            <numerusform>Wiederhergestellt: %n Schritte, Stand %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ShapeSources</name>
    <message>
        <source>Prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Frustum</source>
        <translation>Stumpf</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>&amp;Körper</translation>
    </message>
    <message>
        <source>&amp;Template</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message numerus="yes">
        <source>over %n corner(s)</source>
        <translation>
            <numerusform>über %n Ecke</numerusform>
            <numerusform>über %n Ecken</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TemplateReport</name>
    <message>
        <source>Corner %1: %2</source>
        <translation>Ecke %1: %2</translation>
    </message>
    <message>
        <source>Face %1: %2</source>
        <translation>Fläche %1: %2</translation>
    </message>
    <message>
        <source>The template needs a name.</source>
        <translation>Die Vorlage braucht einen Namen.</translation>
    </message>
    <message>
        <source>Another template has the id “%1”.</source>
        <translation>Eine andere Vorlage hat die Kennung „%1“.</translation>
    </message>
    <message>
        <source>The template needs an id, which names it in files.</source>
        <translation>Die Vorlage braucht eine Kennung, die sie in Dateien benennt.</translation>
    </message>
    <message>
        <source>Use “%1”</source>
        <translation>„%1“ nehmen</translation>
    </message>
    <message>
        <source>The edges %1 of this shape are not parallel.</source>
        <translation>Die Kanten %1 dieser Form sind nicht parallel.</translation>
    </message>
    <message>
        <source>The edges %1 of this shape are at no right angle.</source>
        <translation>Die Kanten %1 dieser Form stehen nicht im rechten Winkel.</translation>
    </message>
    <message>
        <source>The edges %1 of this shape are not equally long.</source>
        <translation>Die Kanten %1 dieser Form sind nicht gleich lang.</translation>
    </message>
    <message>
        <source>Drop the rule</source>
        <translation>Regel weglassen</translation>
    </message>
    <message>
        <source>“%1” has the same shape and the same rules: no drawing can tell the two apart.</source>
        <translation>„%1“ hat dieselbe Form und dieselben Regeln: Keine Zeichnung kann die beiden unterscheiden.</translation>
    </message>
    <message>
        <source>From no side it can be seen well enough to be drawn.</source>
        <translation>Von keiner Seite ist sie gut genug zu sehen, um gezeichnet zu werden.</translation>
    </message>
    <message>
        <source>This template</source>
        <translation>Diese Vorlage</translation>
    </message>
</context>
<context>
    <name>ew::AspectList</name>
    <message>
        <source>from under 1 % of all sides</source>
        <translation>von unter 1 % aller Seiten</translation>
    </message>
    <message>
        <source>from %1 % of all sides</source>
        <translation>von %1 % aller Seiten</translation>
    </message>
    <message numerus="yes">
        <source>opening of %n face(s)</source>
        <translation>
            <numerusform>Öffnung aus %n Fläche</numerusform>
            <numerusform>Öffnung aus %n Flächen</numerusform>
        </translation>
    </message>
    <message>
        <source>opening with what is seen through it</source>
        <translation>Öffnung mit dem, was darin zu sehen ist</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n Fläche</numerusform>
            <numerusform>%n Flächen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, others seen as lines</source>
        <translation>%1, andere als Linien gesehen</translation>
    </message>
    <message>
        <source>Views of the template</source>
        <translation>Ansichten der Vorlage</translation>
    </message>
    <message>
        <source>Drawn by itself</source>
        <translation>Für sich gezeichnet</translation>
    </message>
    <message>
        <source>Drawn on a solid</source>
        <translation>Auf einem Körper gezeichnet</translation>
    </message>
    <message>
        <source>also: %1</source>
        <translation>auch: %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read there: it has too many edges.</source>
        <translation>Dort nicht gelesen: Sie hat zu viele Kanten.</translation>
    </message>
    <message>
        <source>from nearly all sides</source>
        <translation>von fast allen Seiten</translation>
    </message>
</context>
<context>
    <name>ew::FaultList</name>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>ew::NameForm</name>
    <message>
        <source>Na&amp;me</source>
        <translation>Na&amp;me</translation>
    </message>
    <message>
        <source>&amp;Id</source>
        <translation>&amp;Kennung</translation>
    </message>
    <message>
        <source>what people call it</source>
        <translation>wie man sie nennt</translation>
    </message>
    <message>
        <source>A template that is in use keeps its id.</source>
        <translation>Eine Vorlage, die in Gebrauch ist, behält ihre Kennung.</translation>
    </message>
    <message>
        <source>Names the template in files and scripts: small letters, digits and hyphens.</source>
        <translation>Benennt die Vorlage in Dateien und Skripten: Kleinbuchstaben, Ziffern und Bindestriche.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Set id</source>
        <translation>Kennung ändern</translation>
    </message>
</context>
<context>
    <name>ew::RuleList</name>
    <message>
        <source>Parallel: %1</source>
        <translation>Parallel: %1</translation>
    </message>
    <message>
        <source>Right angle: %1</source>
        <translation>Rechter Winkel: %1</translation>
    </message>
    <message>
        <source>Equally long: %1</source>
        <translation>Gleich lang: %1</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>follows from the rules above</source>
        <translation>folgt aus den Regeln darüber</translation>
    </message>
    <message>
        <source>not true of this shape</source>
        <translation>gilt für diese Form nicht</translation>
    </message>
</context>
<context>
    <name>ew::ShapeView</name>
    <message>
        <source>Shape of the template</source>
        <translation>Form der Vorlage</translation>
    </message>
    <message>
        <source>Drag to turn it; click a corner or an edge</source>
        <translation>Ziehen dreht sie; Ecken und Kanten lassen sich anklicken</translation>
    </message>
</context>
<context>
    <name>ew::TemplateEditor</name>
    <message>
        <source>Edit template</source>
        <translation>Vorlage bearbeiten</translation>
    </message>
    <message>
        <source>New template</source>
        <translation>Neue Vorlage</translation>
    </message>
    <message>
        <source>&amp;Shape</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>T&amp;ry it</source>
        <translation>Ausp&amp;robieren</translation>
    </message>
    <message>
        <source>Shape &amp;from</source>
        <translation>Form a&amp;us</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig:</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen:</translation>
    </message>
    <message>
        <source>%1 of the corner</source>
        <translation>%1 der Ecke</translation>
    </message>
    <message>
        <source>Where the corner is in the reference shape</source>
        <translation>Wo die Ecke in der Bezugsform liegt</translation>
    </message>
    <message>
        <source>Found in this shape. Every instance keeps what is ticked.</source>
        <translation>In dieser Form gefunden. Was angehakt ist, halten alle Körper der Vorlage ein.</translation>
    </message>
    <message>
        <source>R&amp;ules</source>
        <translation>R&amp;egeln</translation>
    </message>
    <message>
        <source>&amp;About it</source>
        <translation>An&amp;gaben</translation>
    </message>
    <message>
        <source>Sa&amp;ve changes</source>
        <translation>Än&amp;derungen übernehmen</translation>
    </message>
    <message>
        <source>A&amp;dd to the document</source>
        <translation>In das &amp;Dokument aufnehmen</translation>
    </message>
    <message>
        <source>Corner %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>Edge %1, length %2; its rules are in bold.</source>
        <translation>Kante %1, Länge %2; ihre Regeln sind fett.</translation>
    </message>
    <message>
        <source>Drag to turn it; click a corner or an edge.</source>
        <translation>Ziehen dreht sie; Ecken und Kanten lassen sich anklicken.</translation>
    </message>
    <message>
        <source>All instances have the proportions of this shape.</source>
        <translation>Alle Körper der Vorlage haben die Maßverhältnisse dieser Form.</translation>
    </message>
    <message numerus="yes">
        <source>%n proportion(s) stay open; what a drawing does not tell is taken from this shape.</source>
        <translation>
            <numerusform>%n Maßverhältnis bleibt offen; was eine Zeichnung nicht zeigt, kommt aus dieser Form.</numerusform>
            <numerusform>%n Maßverhältnisse bleiben offen; was eine Zeichnung nicht zeigt, kommt aus dieser Form.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking at it from all sides…</source>
        <translation>Wird von allen Seiten betrachtet …</translation>
    </message>
    <message>
        <source>No views: the shape has to be mended first.</source>
        <translation>Keine Ansichten: Erst muss die Form in Ordnung sein.</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) that it is read from</source>
        <translation>
            <numerusform>%n Ansicht, aus der sie gelesen wird</numerusform>
            <numerusform>%n Ansichten, aus denen sie gelesen wird</numerusform>
        </translation>
    </message>
    <message>
        <source>Set id</source>
        <translation>Kennung ändern</translation>
    </message>
    <message>
        <source>The template was changed.</source>
        <translation>Die Vorlage wurde geändert.</translation>
    </message>
    <message>
        <source>What you changed is lost when it is not saved.</source>
        <translation>Die Änderungen gehen verloren, wenn sie nicht übernommen werden.</translation>
    </message>
    <message>
        <source>Dis&amp;card</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Go on editing</source>
        <translation>&amp;Weiter bearbeiten</translation>
    </message>
    <message>
        <source>Mi&amp;x-ups</source>
        <translation>Ver&amp;wechslungen</translation>
    </message>
</context>
<context>
    <name>ew::TemplateModel</name>
    <message>
        <source>Set rule</source>
        <translation>Regel setzen</translation>
    </message>
    <message>
        <source>Drop rule</source>
        <translation>Regel weglassen</translation>
    </message>
    <message>
        <source>Move corner %1</source>
        <translation>Ecke %1 verschieben</translation>
    </message>
    <message>
        <source>Take another shape</source>
        <translation>Andere Form nehmen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Clear drawing</source>
        <translation>Zeichnung löschen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
</context>
<context>
    <name>ew::TrialCanvas</name>
    <message>
        <source>Sheet to try the template on</source>
        <translation>Blatt zum Ausprobieren der Vorlage</translation>
    </message>
    <message>
        <source>Draw the shape here from any side, with pen or mouse, and see what it is read as.</source>
        <translation>Hier die Form von einer beliebigen Seite zeichnen, mit Stift oder Maus; darunter steht, als was sie gelesen wird.</translation>
    </message>
</context>
<context>
    <name>ew::TrialPage</name>
    <message>
        <source>Clear the s&amp;heet</source>
        <translation>&amp;Blatt leeren</translation>
    </message>
</context>
<context>
    <name>ew::TrialReading</name>
    <message>
        <source>It is read as this template.</source>
        <translation>Es wird als diese Vorlage gelesen.</translation>
    </message>
    <message>
        <source>It is read as “%1”, not as this template.</source>
        <translation>Es wird als „%1“ gelesen, nicht als diese Vorlage.</translation>
    </message>
    <message>
        <source>It is most likely this template, but that is not certain.</source>
        <translation>Es ist am ehesten diese Vorlage, aber das ist nicht sicher.</translation>
    </message>
    <message>
        <source>It could be this template, but another one is more likely.</source>
        <translation>Es könnte diese Vorlage sein, aber eine andere ist wahrscheinlicher.</translation>
    </message>
    <message>
        <source>No template shows this.</source>
        <translation>Keine Vorlage zeigt das.</translation>
    </message>
</context>
<context>
    <name>ew::WordsForm</name>
    <message>
        <source>D&amp;escription</source>
        <translation>Bes&amp;chreibung</translation>
    </message>
    <message>
        <source>Describe</source>
        <translation>Beschreiben</translation>
    </message>
    <message>
        <source>Categor&amp;y</source>
        <translation>Ar&amp;t</translation>
    </message>
    <message>
        <source>Set category</source>
        <translation>Art ändern</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Set tags</source>
        <translation>Schlagwörter ändern</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>&amp;Schlagwörter</translation>
    </message>
    <message>
        <source>Auth&amp;or</source>
        <translation>Aut&amp;or</translation>
    </message>
    <message>
        <source>Set author</source>
        <translation>Autor ändern</translation>
    </message>
    <message>
        <source>&amp;Licence</source>
        <translation>&amp;Lizenz</translation>
    </message>
    <message>
        <source>Set licence</source>
        <translation>Lizenz ändern</translation>
    </message>
    <message>
        <source>Versio&amp;n</source>
        <translation>Versio&amp;n</translation>
    </message>
    <message>
        <source>Set version</source>
        <translation>Version ändern</translation>
    </message>
    <message>
        <source>In another language</source>
        <translation>In einer anderen Sprache</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Name there</source>
        <translation>Name dort</translation>
    </message>
    <message>
        <source>Description there</source>
        <translation>Beschreibung dort</translation>
    </message>
    <message>
        <source>Translate name</source>
        <translation>Namen übersetzen</translation>
    </message>
    <message>
        <source>Translate description</source>
        <translation>Beschreibung übersetzen</translation>
    </message>
</context>
<context>
    <name>ew::ConfusionPage</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>What drawings are read as</source>
        <translation>Als was Zeichnungen gelesen werden</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>read as it</source>
        <translation>so gelesen</translation>
    </message>
    <message>
        <source>asked about</source>
        <translation>nachgefragt</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>read as another</source>
        <translation>als andere gelesen</translation>
    </message>
    <message>
        <source>This template</source>
        <translation>Diese Vorlage</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Dra&amp;w them</source>
        <translation>&amp;Zeichnen lassen</translation>
    </message>
    <message>
        <source>Drawings are made and read…</source>
        <translation>Zeichnungen werden gemacht und gelesen …</translation>
    </message>
    <message>
        <source>A model of a light hand draws this template, and those that look the same from somewhere, %1 times each from random sides, and all are read.</source>
        <translation>Ein Modell einer leichten Hand zeichnet diese Vorlage und die, die von irgendwo gleich aussehen, je %1-mal von zufälligen Seiten; alle Zeichnungen werden gelesen.</translation>
    </message>
    <message>
        <source>The template was changed since these were drawn.</source>
        <translation>Die Vorlage wurde geändert, seit diese gezeichnet wurden.</translation>
    </message>
    <message>
        <source>Of %1 drawings of each.</source>
        <translation>Von je %1 Zeichnungen.</translation>
    </message>
</context>
</TS>
