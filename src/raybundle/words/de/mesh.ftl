mesh-no_triangles = Die Vermaschung { $name } hat keine Dreiecke.

mesh-vertex_not_finite = Vermaschung { $name }: Eckpunkt { $vertex } hat eine Koordinate, die keine endliche Zahl ist.

mesh-unknown_vertex = Vermaschung { $name }: Ein Dreieck verweist auf Eckpunkt { $vertex }, es gibt aber nur { $n }.

mesh-no_area = Vermaschung { $name }: Die Dreiecke haben keine Fläche.
    .do = Einheit und Eckpunkte der Vermaschung prüfen.

mesh-nothing_to_measure = Vermaschung { $name }: Alle Dreiecke sind von der Messung ausgenommen.
    .do = Mindestens einen Teil wählen, der zu messen ist.
