#include "files/vtk_messages.hpp"

#include <algorithm>

#include <vtkObjectFactory.h>

namespace cleave::app {

class VtkMessages::Window : public vtkOutputWindow {
 public:
  static Window* New() { VTK_STANDARD_NEW_BODY(Window); }
  vtkTypeMacro(Window, vtkOutputWindow)

  void DisplayText(const char* text) override { messages.emplace_back(text); }
  void DisplayErrorText(const char* text) override { DisplayText(text); }
  void DisplayWarningText(const char* text) override { DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { DisplayText(text); }

  std::vector<std::string> messages;
};

namespace {

/// VTK writes "ERROR: In FILE, line N\nCLASS (ADDRESS): MESSAGE\n\n".
std::string without_place(const std::string& message) {
  const auto address = message.find("): ");
  std::string text = address == std::string::npos ? message : message.substr(address + 3);
  while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' '))
    text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

VtkMessages::VtkMessages()
    : before_(vtkOutputWindow::GetInstance()), window_(vtkSmartPointer<Window>::New()) {
  vtkOutputWindow::SetInstance(window_);
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(before_); }

bool VtkMessages::any() const { return !window_->messages.empty(); }

std::string VtkMessages::text() const {
  std::vector<std::string> said;
  for (const std::string& message : window_->messages) {
    const std::string text = without_place(message);
    if (std::find(said.begin(), said.end(), text) == said.end()) said.push_back(text);
  }
  std::string all;
  for (const std::string& text : said) all += (all.empty() ? "" : "; ") + text;
  return all;
}

}  // namespace cleave::app
