deposit-entries_missing = Il manque à la fiche ce que demandent les archives : { LIST($names, most: 6) }.

deposit-photographs_missing = { $n } photographies manquent : { LIST($names, most: 3) }.
