scene_prior-rpc = Die RPC von { $ids } haben keine Genauigkeit (ERR_BIAS); angenommen sind { $sigma_m } m am Boden.
    .why = Ohne Passpunkte ist das Ergebnis nur so gut wie diese Annahme.
    .do = Passpunkte angeben: { OPTION("control") }.

scene_prior-orbit = { $ids } hat keine RPC; die Lagewinkel aus der Orbitdatei gelten als auf { $sigma_rad } rad bekannt.
    .why = Ohne Passpunkte ist das Ergebnis nur so gut wie diese Annahme.
    .do = Passpunkte angeben: { OPTION("control") }.

scene_prior-radar = Entfernung und Uhr von { $ids } gelten als auf { $sigma_m } m und { $sigma_s } s bekannt.
    .why = Ohne Passpunkte ist das Ergebnis nur so gut wie diese Annahme.
    .do = Passpunkte angeben: { OPTION("control") }.
