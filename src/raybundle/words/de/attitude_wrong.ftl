attitude_wrong = { $n } { $n ->
     [one] Satz Lagewinkel widerspricht
     *[other] Sätze Lagewinkel widersprechen
    } den Aufnahmen um bis zu { NUM($off_deg, decimals: 1) }°, weggelassen: { $ids }.
    .why = Die anderen Lagewinkel streuen um { NUM($scatter_deg, decimals: 2) }°.
