mark_contradicts = { $n ->
        [one] La marque de { $point } dans { $images } contredit les autres
       *[other] Les marques de { $point } se contredisent : { $images }
    }.

mark_contradicts-excluded = { $n ->
        [one] La marque de { $point } dans { $images } contredit les autres
       *[other] Les marques de { $point } se contredisent : { $images }
    }.

mark_contradicts-undecided = Les { $n } marques de { $point } se contredisent : { LIST($images, most: 3) }.
