object-takes_no_line = Das Objekt { $name } hat keine Punktfolge.
    .do = { $needs } angeben.

object-number_count = Objekt { $name }: { $n } Zahlen sind angegeben.
    .do = { $needs } angeben.

object-dimension_out_of_range = Objekt { $name }: { $dimension } ist { $value_m } m.
    .do = Einen Wert über 0 und höchstens { $largest_m } m angeben.

object-unknown = Objekt { $text } ist weder eine Objektart noch eine Datei oder ein Ordner eines Objekts.
    .do = Eine Art ({ LIST($kinds, most: 20) }), ein Dreiecksnetz ({ LIST($meshes, most: 9) }), ein Höhenraster ({ LIST($rasters, most: 9) }) oder einen Ergebnisordner angeben.

object-number_form = Objekt { $text }: { $name } braucht Zahlen mit Kommas dazwischen.
    .do = { $needs } angeben, zum Beispiel { $example }.
