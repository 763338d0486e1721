# cmake -DINPUT=file -DOUTPUT=file.cpp -DFUNCTION=name -P embed.cmake
#
# Writes a .cpp whose function gives the text of INPUT.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "#include \"reports/text/embedded.h\"

namespace limitgauge::reports::embedded {
std::string_view ${FUNCTION}() {
  return R\"LIMITGAUGE(${text})LIMITGAUGE\";
}
}  // namespace limitgauge::reports::embedded
")
