attitudes_undecided = Die Lagewinkel aus { $source } sind nicht verwendet: Möglich sind { $ids }.
    .why = Die Aufnahmen entscheiden ab { $needed } orientierten Aufnahmen; es sind { $n }.
    .do = Die richtige Lesart angeben, z. B. { OPTION("attitudes", $first) }.
