control_without_photograph = { $n } mesure(s) de { $table } sont dans des photographies manquantes : { LIST($names, most: 5) }.
