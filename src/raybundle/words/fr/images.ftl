images-no_base = Les rayons vers { $parallel } de { $points } points objet sont parallèles à { $limit_deg }° près : { $images }.
