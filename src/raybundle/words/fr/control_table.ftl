control_table-no_coordinates = { $table } : aucune ligne n'a de coordonnée.

control_table-point_twice = { $table } : le point { $point } figure plusieurs fois.

control_table-not_readable = { $table } ne peut pas être lu comme une table ({ $detail }).
