#include "files/vtk_messages.hpp"

#include <string_view>
#include <vector>

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include "files/input_text.hpp"

namespace cleave::app {

class VtkMessages::Window : public vtkOutputWindow {
 public:
  static Window* New() { VTK_STANDARD_NEW_BODY(Window); }

  void DisplayText(const char* text) override { messages.emplace_back(text); }
  void DisplayErrorText(const char* text) override { DisplayText(text); }
  void DisplayWarningText(const char* text) override { DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { DisplayText(text); }

  std::vector<std::string> messages;
};

namespace {

/// VTK writes "ERROR: In FILE, line N\nCLASS (ADDRESS): MESSAGE\n\n".
std::string without_place(const std::string& message) {
  const auto line = message.find('\n');
  std::string text = message.find(": In ") < line ? message.substr(line + 1) : message;
  const auto address = text.find(" (0x");
  if (address != std::string::npos) text.erase(0, text.find("): ", address) + 3);
  while (!text.empty() && std::string_view("\n .!").find(text.back()) != std::string_view::npos)
    text.pop_back();
  return printable(text);
}

}  // namespace

VtkMessages::VtkMessages()
    : before_(vtkOutputWindow::GetInstance()), window_(vtkSmartPointer<Window>::New()) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // it prints beside the window
  vtkOutputWindow::SetInstance(window_);
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(before_); }

bool VtkMessages::any() const { return !window_->messages.empty(); }

std::string VtkMessages::first() const {
  return any() ? without_place(window_->messages.front()) : "no reason";
}

}  // namespace cleave::app
