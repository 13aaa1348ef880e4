attitude_wrong = { $n } { $n ->
     [one] Lage widerspricht
     *[other] Lagen widersprechen
    } den Aufnahmen um bis zu { NUM($off_deg, decimals: 1) }°, weggelassen: { $ids }.
    .why = Die anderen streuen um { NUM($scatter_deg, decimals: 2) }°.
