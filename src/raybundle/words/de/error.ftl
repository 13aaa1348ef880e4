error-other = Ursache: { $detail }
