depths-small_angle = Les rayons de ces photographies se coupent à { NUM($angle_deg, digits: 2) }° (médiane) ; il faut { $least_deg }°.

depths-scales_differ = Les échelles de ces photographies diffèrent d'un facteur { NUM($ratio, digits: 2) } (limite { $limit }).

depths-no_common_points = Il n'y a pas deux photographies avec assez de points communs.

depths-no_partner = Aucune autre photographie n'a assez de points communs avec cette photographie.

depths-no_useful_partner = Aucune autre photographie ne forme une paire utile avec cette photographie.

depths-region_not_shown = La photographie ne montre pas la région.
