# $n = 24
# $mb = 12.3
deposit-written = Packed: { $n } files, { NUM($mb, digits: 3) } MB.
