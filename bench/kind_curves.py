CURVES = ()
