query-image_without_part = L'image { $image } n'a pas participé à la compensation.

query-unknown_own = { $name } n'est pas une inconnue d'un type d'observation qui participe.

query-unknown = { $name } n'est pas une inconnue de cette compensation.
