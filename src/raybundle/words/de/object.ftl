object-takes_no_line = Das Objekt { $name } hat keine Punktfolge.
    .do = { $needs } angeben.

object-number_count = Objekt { $name }: { $n } Zahlen sind angegeben.
    .do = { $needs } angeben.

object-dimension_out_of_range = Objekt { $name }: { $dimension } ist { $value_m } m.
    .do = Einen Wert über 0 und höchstens { $largest_m } m angeben.
