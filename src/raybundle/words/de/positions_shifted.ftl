positions_shifted = Passpunkte und Positionen ({ $antenna }) weichen um { $plan } { $unit } in der Lage, { $height } { $unit } in der Höhe ab.
    .why = Die angegebene Genauigkeit erklärt { $sigma_plan } und { $sigma_height } { $unit }. Der Versatz wird geschätzt, die Passpunkte gelten als richtig.
    .do = Stehen beide im selben System, die Koordinaten der Passpunkte und der Basisstation prüfen.

positions_shifted-height = Passpunkte und Positionen ({ $antenna }) weichen um { $height } { $unit } in der Höhe ab.
    .why = Die angegebene Genauigkeit erklärt { $sigma_height } { $unit }. Der Versatz wird geschätzt, die Passpunkte gelten als richtig.
    .do = Zählen beide Höhen von derselben Fläche (Ellipsoid oder Meeresspiegel), die Höhen der Passpunkte prüfen.
