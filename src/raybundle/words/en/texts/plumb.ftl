plumb-block = Z of the block

# $by = "edges"
# $edges = 12
# $known = true
# $sigma_deg = 0.4
plumb-block_found = Z of the block, { $by ->
        [edges] by { $edges } plumb { $edges ->
            [one] edge
            *[other] edges
        } in the photographs
        [given] as given
        *[held] by how the photographs were held
    }{ $known ->
        [yes] , ± { NUM($sigma_deg, digits: 2) } degrees
        *[no] {""}
    }

# $lines = 2
# $levels = 1
plumb-block_observed = Z of the block, by { $lines ->
        [0] {""}
        [one] { $lines } measured plumb line
        *[other] { $lines } measured plumb lines
    }{ $lines ->
        [0] {""}
        *[other] { $levels ->
            [0] {""}
            *[other] {" "}and{" "}
        }
    }{ $levels ->
        [0] {""}
        [one] { $levels } level
        *[other] { $levels } levels
    }

# $n = 2
plumb-lines = { $n } measured plumb { $n ->
        [one] line
        *[other] lines
    }

# $lower = "A"
# $upper = "B"
plumb-points = from { $lower } to { $upper }

# $back = true
# $lean_deg = 15.2
# $sigma_known = true
# $sigma_deg = 0.4
plumb-lean = its points lean { $back ->
        [yes] back
        *[no] forward
    } by { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrees
