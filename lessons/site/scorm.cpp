#include <fmt/format.h>

#include <derivations/program/files.hpp>
#include <lessons/page/render.hpp>
#include <lessons/site/scorm.hpp>
#include <stdexcept>

namespace rederive::site {
using page::escaped;
namespace fs = std::filesystem;

std::string scorm_manifest(const std::string& title,
                           const std::vector<std::pair<fs::path, std::string>>& files) {
  std::string names;
  for (const auto& [name, text] : files)
    if (name != inlined_judge) names += fmt::format("      <file href=\"{}\"/>\n", escaped(name.string()));
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="rederive" version="1.1"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
    xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:schemaLocation="http://www.imsproject.org/xsd/imscp_rootv1p1p2 imscp_rootv1p1p2.xsd
                        http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="course">
    <organization identifier="course">
      <title>{0}</title>
      <item identifier="exercises" identifierref="pages" isvisible="true">
        <title>{0}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="pages" type="webcontent" adlcp:scormtype="sco" href="exercises.html">
{1}    </resource>
  </resources>
</manifest>
)",
                     escaped(title), names);
}

void pack_scorm(const fs::path& folder) {
  static constexpr const char* program =
      "import sys, xml.etree.ElementTree as tree, zipfile\n"
      "names = [one.get('href') for one in tree.parse('imsmanifest.xml').iter() if "
      "one.tag.endswith('}file')]\n"
      "with zipfile.ZipFile('scorm.zip', 'w', zipfile.ZIP_DEFLATED) as package:\n"
      "    for name in ['imsmanifest.xml'] + names:\n"
      "        package.writestr(zipfile.ZipInfo(name), open(name, 'rb').read(), zipfile.ZIP_DEFLATED)\n";
  const page::Said said =
      page::said_by("cd " + page::in_quotes(folder) + " && python3 -c " + page::in_quotes(program) + " 2>&1");
  if (said.status != 0)
    throw std::runtime_error("scorm.zip could not be made, which needs python3:\n" + said.text);
}

}  // namespace rederive::site
