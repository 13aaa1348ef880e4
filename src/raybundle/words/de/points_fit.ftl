points_fit-apart = Punkt { $point }: { $apart_mm } mm Abstand.

points_fit-names_exchanged = Mit vertauschten Namen { $first } und { $second } passen beide.

points_fit-instead = Stattdessen { $names } auszuschließen erklärt die Unterschiede ebenso gut.
