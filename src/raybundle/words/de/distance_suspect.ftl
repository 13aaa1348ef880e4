distance_suspect-control = Maßstabsstrecke { $name } widerspricht den Passpunkten: { NUM($length, digits: 6) } { $unit } angegeben, { NUM($shown, digits: 6) } { $unit } gemessen.
    .why = |w| ist { NUM($w, decimals: 1) } (Grenze { NUM($limit, decimals: 1) }); ohne diese Strecke sinken die Verbesserungen von Passpunkten und Strecken vom { NUM($before, digits: 2) }- auf das { NUM($after, digits: 2) }-Fache des Angegebenen.
    .do = Zuerst Länge und Endpunkte dieser Strecke prüfen, dann die Passpunkte.

distance_suspect-far = Maßstabsstrecke { $name } widerspricht den übrigen Beobachtungen um mehr als { PERCENT($share) } % ihrer Länge.
    .why = Angegeben: { NUM($given, digits: 12) } { $unit } (Sigma { $sigma } { $unit }, |w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }).
    .do = Länge, Einheit und Endpunkte prüfen.

distance_suspect-contradict = { $bars } Maßstabsstrecken widersprechen einander: { LIST($ids, most: 5) }.
    .why = Ohne sie passt der Block; welche falsch ist, ist nicht eindeutig.
    .do = Längen, Einheiten und Endpunkte der Strecken prüfen oder eine weitere Länge messen.

distance_suspect-factor = { $name } ({ NUM($given, digits: 6) } { $unit }): relativer Faktor { NUM($factor, digits: 5) }

distance_suspect-left_out = { $bars } { $bars ->
     [one] Maßstabsstrecke widerspricht allen anderen Beobachtungen und ist
     *[other] Maßstabsstrecken widersprechen allen anderen Beobachtungen und sind
    } weggelassen: { LIST($ids, most: 5) }.
    .do = { $likely ->
     [none] Länge, Einheit und Endpunkte prüfen
     *[other] Länge, Einheit (wahrscheinlich { $likely }) und Endpunkte prüfen
    }.

distance_suspect-bar = Maßstabsstrecke { $name }: { NUM($given, digits: 6) } { $unit } angegeben, { NUM($shown, digits: 6) } { $unit } im Block.

distance_suspect-beside_control = Maßstabsstrecke { $start } - { $end } widerspricht den Passpunkten, weggelassen: Faktor { NUM($ratio, digits: 4) } (Grenze { $limit }).
    .why = Angegeben sind { NUM($given_m, digits: 6) } m; im System der Passpunkte sind es { NUM($measured_m, digits: 4) } m.
    .do = { $of ->
     [bar] Die Länge der Strecke in Metern angeben; sie ist wahrscheinlich in { $likely }
     [control] Die Passpunkte in Metern angeben; sie sind wahrscheinlich in { $likely }
     *[none] Länge und Endpunkte der Strecke und die Einheit der Passpunkte prüfen
    }.
