mask-none_found = Der Ordner hat keine Maske zu den { $n } Aufnahmen.
    .why = Groß- und Kleinschreibung der Namen zählt; ähnliche gibt es für: { $similar }.
    .do = Masken wie { $names } benennen.

mask-all_hidden = Die Masken schließen { $hidden } von { $n } Aufnahmen ganz aus; zwei sind nötig.
    .why = In einer Maske ist 0 oder durchsichtig ausgeschlossen, jeder andere Wert wird verwendet.
    .do = Prüfen, ob die Masken invertiert oder leer sind: { LIST($names, most: 3) }.

mask-size_differs = Die Maske hat { $width_px } x { $height_px } px, die Aufnahme { $photograph } { $photograph_width_px } x { $photograph_height_px } px.
    .why = Die Maske wird nicht verwendet: Größen müssen gleich oder ganze Vielfache sein (EXIF-Orientierung { $orientation }).
    .do = Die Maske neu exportieren.

mask-corner_form = Ecke { $corner } des Polygons ist { $word }.
    .do = x und y mit Komma, Ecken mit Leerzeichen dazwischen angeben: '10,20 300,20 300,200'

mask-other_name = { $name } weicht von den Namen einer Maske für diese Aufnahme ab.
    .do = In einen der Namen { $names } (COLMAP, Metashape) umbenennen, Groß- und Kleinschreibung gleich.
