mesh-no_triangles = Das Dreiecksnetz { $name } hat keine Dreiecke.
    .do = Aus der Punktwolke ein Dreiecksnetz erzeugen oder eine andere Datei angeben.

mesh-vertex_not_finite = Dreiecksnetz { $name }: Eckpunkt { $vertex } hat eine Koordinate, die keine endliche Zahl ist.
    .do = Die Koordinate korrigieren oder den Eckpunkt mit seinen Dreiecken löschen.

mesh-unknown_vertex = Dreiecksnetz { $name }: Ein Dreieck verweist auf Eckpunkt { $vertex }, es gibt aber nur { $n }.
    .do = Das Dreieck korrigieren oder die fehlenden Eckpunkte ergänzen.

mesh-no_area = Dreiecksnetz { $name }: Die Dreiecke haben keine Fläche.
    .do = Einheit und Eckpunkte des Dreiecksnetzes prüfen.

mesh-nothing_to_measure = Dreiecksnetz { $name }: Alle Dreiecke sind von der Messung ausgenommen.
    .do = Mindestens einen Teil wählen, der zu messen ist.

mesh-not_readable = Die Datei ist nicht als Dreiecksnetz lesbar ({ $detail }).
    .do = Ein Dreiecksnetz als STL, PLY oder OBJ angeben.

mesh-too_many_triangles = Das Dreiecksnetz hat { $n } Dreiecke; höchstens { $most } werden gelesen.
    .do = Das Dreiecksnetz zuvor vereinfachen.

mesh-too_small = Das Dreiecksnetz ist { $extent_mm } mm groß, wenn seine Einheit { $unit_m } m ist; nötig sind { $least_mm } mm.
    .do = Die Einheit des Dreiecksnetzes angeben; { OPTION("unit", 0.001) } steht für Millimeter.
