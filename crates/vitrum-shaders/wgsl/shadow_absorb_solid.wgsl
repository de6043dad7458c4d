struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: type_4,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_9;
@group(0) @binding(2)
var<storage, read_write> global_2: type_12;
@group(0) @binding(1)
var<storage> global_3: type_7;
fn function_() {
var phi_107_: i32;
var phi_110_: u32;
var phi_108_: i32;
var phi_111_: u32;
var local: u32;
var phi_150_: i32;
var phi_153_: u32;
var phi_188_: i32;
var phi_243_: u32;
var phi_308_: u32;
var phi_369_: u32;
var phi_151_: i32;
var phi_154_: u32;
let _e23 = global;
let _e25 = arrayLength((&global_3.member));
let _e27 = arrayLength((&global_2.member));
let _e30 = global_1.member.member;
if (_e23.x < _e30.member) {
if (_e23.y < _e30.member_1) {
let _e40 = global_1.member.member.member;
let _e42 = ((_e23.y * _e40) + _e23.x);
let _e45 = global_1.member.member_1;
if (_e42 < _e45) {
let _e49 = global_1.member.member_2;
let _e50 = bitcast<i32>(_e49);
let _e51 = bitcast<i32>(_e42);
let _e53 = (_e51 * (_e50 + 1i));
phi_107_ = 0i;
phi_110_ = 0u;
loop {
let _e55 = phi_107_;
let _e57 = phi_110_;
local = _e57;
let _e58 = (_e55 <= _e50);
if _e58 {
let _e59 = (_e53 + _e55);
let _e61 = (bitcast<i32>(_e25) - 1i);
let _e63 = select(_e61, _e59, (_e59 < _e61));
let _e69 = global_3.member[bitcast<u32>(select(0i, _e63, (_e63 > 0i)))];
phi_108_ = (_e55 + 1i);
phi_111_ = (_e57 + _e69);
} else {
phi_108_ = i32();
phi_111_ = u32();
}
let _e73 = phi_108_;
let _e75 = phi_111_;
continue;
continuing {
phi_107_ = _e73;
phi_110_ = _e75;
break if !(_e58);
}
}
let _e78 = local;
if (_e78 == 0u) {
let _e82 = global_1.member.member_8;
let _e90 = global_1.member.member_7;
let _e91 = bitcast<i32>(_e90);
phi_150_ = 0i;
phi_153_ = 0u;
loop {
let _e93 = phi_150_;
let _e95 = phi_153_;
let _e96 = (_e93 < _e50);
if _e96 {
let _e97 = (_e53 + _e93);
let _e99 = (bitcast<i32>(_e25) - 1i);
let _e101 = select(_e99, _e97, (_e97 < _e99));
let _e107 = global_3.member[bitcast<u32>(select(0i, _e101, (_e101 > 0i)))];
let _e108 = (_e95 + _e107);
let _e109 = bitcast<i32>(_e108);
if (_e109 == 0i) {
} else {
if (_e109 < 0i) {
phi_188_ = -(_e109);
} else {
phi_188_ = _e109;
}
let _e114 = phi_188_;
let _e116 = (f32(_e114) * (1f / f32((1u << bitcast<u32>((_e82 & 31u))))));
let _e118 = select(1f, _e116, (_e116 < 1f));
let _e122 = ((((_e51 * _e50) + _e93) * _e91) * 2i);
let _e126 = global_1.member.member_10.member;
let _e129 = (((_e126 * _e118) * 16777216f) + 0.5f);
let _e131 = select(-1073741800f, _e129, (_e129 > -1073741800f));
let _e133 = select(1073741800f, _e131, (_e131 < 1073741800f));
let _e140 = select(0i, select(select(i32(_e133), i32(-2147483648), (_e133 < -2147483600f)), 2147483647i, (_e133 > 2147483500f)), (_e133 == _e133));
let _e144 = (_e140 - select(0i, 1i, (_e133 < f32(_e140))));
if (_e144 == 0i) {
} else {
let _e146 = bitcast<u32>(_e144);
let _e147 = bitcast<u32>(_e122);
if (_e147 < _e27) {
let _e151 = atomicAdd((&global_2.member[_e147]), _e146);
phi_243_ = _e151;
} else {
phi_243_ = 0u;
}
let _e153 = phi_243_;
let _e160 = (bitcast<u32>((_e144 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e153 + _e146) < _e146)));
if (_e160 == 0u) {
} else {
let _e162 = (_e147 + 1u);
if (_e162 < _e27) {
let _e166 = atomicAdd((&global_2.member[_e162]), _e160);
}
}
}
if (_e91 > 1i) {
let _e172 = global_1.member.member_10.member_1;
let _e175 = (((_e172 * _e118) * 16777216f) + 0.5f);
let _e177 = select(-1073741800f, _e175, (_e175 > -1073741800f));
let _e179 = select(1073741800f, _e177, (_e177 < 1073741800f));
let _e186 = select(0i, select(select(i32(_e179), i32(-2147483648), (_e179 < -2147483600f)), 2147483647i, (_e179 > 2147483500f)), (_e179 == _e179));
let _e190 = (_e186 - select(0i, 1i, (_e179 < f32(_e186))));
if (_e190 == 0i) {
} else {
let _e192 = bitcast<u32>(_e190);
let _e193 = bitcast<u32>((_e122 + 2i));
if (_e193 < _e27) {
let _e197 = atomicAdd((&global_2.member[_e193]), _e192);
phi_308_ = _e197;
} else {
phi_308_ = 0u;
}
let _e199 = phi_308_;
let _e206 = (bitcast<u32>((_e190 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e199 + _e192) < _e192)));
if (_e206 == 0u) {
} else {
let _e208 = (_e193 + 1u);
if (_e208 < _e27) {
let _e212 = atomicAdd((&global_2.member[_e208]), _e206);
}
}
}
let _e217 = global_1.member.member_10.member_2;
let _e220 = (((_e217 * _e118) * 16777216f) + 0.5f);
let _e222 = select(-1073741800f, _e220, (_e220 > -1073741800f));
let _e224 = select(1073741800f, _e222, (_e222 < 1073741800f));
let _e231 = select(0i, select(select(i32(_e224), i32(-2147483648), (_e224 < -2147483600f)), 2147483647i, (_e224 > 2147483500f)), (_e224 == _e224));
let _e235 = (_e231 - select(0i, 1i, (_e224 < f32(_e231))));
if (_e235 == 0i) {
} else {
let _e237 = bitcast<u32>(_e235);
let _e238 = bitcast<u32>((_e122 + 4i));
if (_e238 < _e27) {
let _e242 = atomicAdd((&global_2.member[_e238]), _e237);
phi_369_ = _e242;
} else {
phi_369_ = 0u;
}
let _e244 = phi_369_;
let _e251 = (bitcast<u32>((_e235 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e244 + _e237) < _e237)));
if (_e251 == 0u) {
} else {
let _e253 = (_e238 + 1u);
if (_e253 < _e27) {
let _e257 = atomicAdd((&global_2.member[_e253]), _e251);
}
}
}
}
}
phi_151_ = (_e93 + 1i);
phi_154_ = _e108;
} else {
phi_151_ = i32();
phi_154_ = u32();
}
let _e260 = phi_151_;
let _e262 = phi_154_;
continue;
continuing {
phi_150_ = _e260;
phi_153_ = _e262;
break if !(_e96);
}
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
