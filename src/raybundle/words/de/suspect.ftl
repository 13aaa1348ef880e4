suspect-value = { $name } { $component } ({ observations-kind }) widerspricht den übrigen Beobachtungen um { NUM($off, digits: 2) } { $unit }.
    .why = Angegeben: { NUM($given, digits: 12) } { $unit }, nach den übrigen { NUM($shown, digits: 12) } { $unit } (Sigma { $sigma } { $unit }, |w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }).
    .do = Diesen Wert prüfen.

suspect-others = Statt { $name } kann { LIST($names, most: 10) } falsch sein; die Beobachtungen können diese Werte nicht trennen.

suspect-beside = Wenn { $name } korrigiert ist, verwirft der Test { LIST($names, most: 10) } nicht mehr.
    .do = Zuerst { $name } korrigieren, dann neu ausgleichen.
