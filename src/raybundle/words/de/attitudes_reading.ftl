attitudes_reading = Die Aufnahmen entscheiden: Die Lagewinkel aus { $source } sind { $reading }.
    .why = Streuung gegen die Aufnahmen: { NUM($scatter_deg, decimals: 3) }° als { $reading }, { NUM($other_deg, decimals: 3) }° als { $other }.
