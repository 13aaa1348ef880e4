distance_suspect-control = Maßstabsstrecke { $name } widerspricht den Passpunkten: { NUM($length, digits: 6) } { $unit } angegeben, { NUM($shown, digits: 6) } { $unit } gemessen.
    .why = |w| ist { NUM($w, decimals: 1) } (Grenze { NUM($limit, decimals: 1) }); ohne diese Strecke sinken die Residuen von Passpunkten und Strecken vom { NUM($before, digits: 2) }- auf das { NUM($after, digits: 2) }-Fache des Angegebenen.
    .do = Ihre Länge und die Namen ihrer Enden prüfen, vor allen Passpunkten.

distance_suspect-far = Maßstabsstrecke { $name } widerspricht den übrigen Beobachtungen um mehr als { PERCENT($share) } % ihrer Länge.
    .why = Angegeben: { NUM($given, digits: 12) } { $unit } (Sigma { $sigma } { $unit }, |w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }).
    .do = Länge, Einheit und Endpunkte prüfen.
