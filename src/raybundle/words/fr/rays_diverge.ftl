rays_diverge = { $n } point(s) aux rayons divergents écarté(s) : { $ids }.
