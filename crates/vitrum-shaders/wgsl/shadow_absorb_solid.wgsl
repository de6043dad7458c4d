struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
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
var phi_109_: i32;
var phi_112_: u32;
var phi_110_: i32;
var phi_113_: u32;
var local: u32;
var phi_154_: i32;
var phi_157_: u32;
var phi_192_: i32;
var phi_247_: u32;
var phi_312_: u32;
var phi_373_: u32;
var phi_155_: i32;
var phi_158_: u32;
let _e25 = global;
let _e27 = arrayLength((&global_3.member));
let _e29 = arrayLength((&global_2.member));
let _e33 = global_1.member.member[0u];
let _e37 = global_1.member.member[1u];
if (_e25.x < _e33) {
if (_e25.y < _e37) {
let _e43 = ((_e25.y * _e33) + _e25.x);
let _e47 = global_1.member.member[3u];
if (_e43 < _e47) {
let _e52 = global_1.member.member_1[0u];
let _e53 = bitcast<i32>(_e52);
let _e54 = bitcast<i32>(_e43);
let _e56 = (_e54 * (_e53 + 1i));
phi_109_ = 0i;
phi_112_ = 0u;
loop {
let _e58 = phi_109_;
let _e60 = phi_112_;
local = _e60;
let _e61 = (_e58 <= _e53);
if _e61 {
let _e62 = (_e56 + _e58);
let _e64 = (bitcast<i32>(_e27) - 1i);
let _e66 = select(_e64, _e62, (_e62 < _e64));
let _e72 = global_3.member[bitcast<u32>(select(0i, _e66, (_e66 > 0i)))];
phi_110_ = (_e58 + 1i);
phi_113_ = (_e60 + _e72);
} else {
phi_110_ = i32();
phi_113_ = u32();
}
let _e76 = phi_110_;
let _e78 = phi_113_;
continue;
continuing {
phi_109_ = _e76;
phi_112_ = _e78;
break if !(_e61);
}
}
let _e81 = local;
if (_e81 == 0u) {
let _e86 = global_1.member.member_2[2u];
let _e95 = global_1.member.member_2[0u];
let _e96 = bitcast<i32>(_e95);
phi_154_ = 0i;
phi_157_ = 0u;
loop {
let _e98 = phi_154_;
let _e100 = phi_157_;
let _e101 = (_e98 < _e53);
if _e101 {
let _e102 = (_e56 + _e98);
let _e104 = (bitcast<i32>(_e27) - 1i);
let _e106 = select(_e104, _e102, (_e102 < _e104));
let _e112 = global_3.member[bitcast<u32>(select(0i, _e106, (_e106 > 0i)))];
let _e113 = (_e100 + _e112);
let _e114 = bitcast<i32>(_e113);
if (_e114 == 0i) {
} else {
if (_e114 < 0i) {
phi_192_ = -(_e114);
} else {
phi_192_ = _e114;
}
let _e119 = phi_192_;
let _e121 = (f32(_e119) * (1f / f32((1u << bitcast<u32>((_e86 & 31u))))));
let _e123 = select(1f, _e121, (_e121 < 1f));
let _e127 = ((((_e54 * _e53) + _e98) * _e96) * 2i);
let _e131 = global_1.member.member_3.member;
let _e134 = (((_e131 * _e123) * 16777216f) + 0.5f);
let _e136 = select(-1073741800f, _e134, (_e134 > -1073741800f));
let _e138 = select(1073741800f, _e136, (_e136 < 1073741800f));
let _e145 = select(0i, select(select(i32(_e138), i32(-2147483648), (_e138 < -2147483600f)), 2147483647i, (_e138 > 2147483500f)), (_e138 == _e138));
let _e149 = (_e145 - select(0i, 1i, (_e138 < f32(_e145))));
if (_e149 == 0i) {
} else {
let _e151 = bitcast<u32>(_e149);
let _e152 = bitcast<u32>(_e127);
if (_e152 < _e29) {
let _e156 = atomicAdd((&global_2.member[_e152]), _e151);
phi_247_ = _e156;
} else {
phi_247_ = 0u;
}
let _e158 = phi_247_;
let _e165 = (bitcast<u32>((_e149 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e158 + _e151) < _e151)));
if (_e165 == 0u) {
} else {
let _e167 = (_e152 + 1u);
if (_e167 < _e29) {
let _e171 = atomicAdd((&global_2.member[_e167]), _e165);
}
}
}
if (_e96 > 1i) {
let _e177 = global_1.member.member_3.member_1;
let _e180 = (((_e177 * _e123) * 16777216f) + 0.5f);
let _e182 = select(-1073741800f, _e180, (_e180 > -1073741800f));
let _e184 = select(1073741800f, _e182, (_e182 < 1073741800f));
let _e191 = select(0i, select(select(i32(_e184), i32(-2147483648), (_e184 < -2147483600f)), 2147483647i, (_e184 > 2147483500f)), (_e184 == _e184));
let _e195 = (_e191 - select(0i, 1i, (_e184 < f32(_e191))));
if (_e195 == 0i) {
} else {
let _e197 = bitcast<u32>(_e195);
let _e198 = bitcast<u32>((_e127 + 2i));
if (_e198 < _e29) {
let _e202 = atomicAdd((&global_2.member[_e198]), _e197);
phi_312_ = _e202;
} else {
phi_312_ = 0u;
}
let _e204 = phi_312_;
let _e211 = (bitcast<u32>((_e195 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e204 + _e197) < _e197)));
if (_e211 == 0u) {
} else {
let _e213 = (_e198 + 1u);
if (_e213 < _e29) {
let _e217 = atomicAdd((&global_2.member[_e213]), _e211);
}
}
}
let _e222 = global_1.member.member_3.member_2;
let _e225 = (((_e222 * _e123) * 16777216f) + 0.5f);
let _e227 = select(-1073741800f, _e225, (_e225 > -1073741800f));
let _e229 = select(1073741800f, _e227, (_e227 < 1073741800f));
let _e236 = select(0i, select(select(i32(_e229), i32(-2147483648), (_e229 < -2147483600f)), 2147483647i, (_e229 > 2147483500f)), (_e229 == _e229));
let _e240 = (_e236 - select(0i, 1i, (_e229 < f32(_e236))));
if (_e240 == 0i) {
} else {
let _e242 = bitcast<u32>(_e240);
let _e243 = bitcast<u32>((_e127 + 4i));
if (_e243 < _e29) {
let _e247 = atomicAdd((&global_2.member[_e243]), _e242);
phi_373_ = _e247;
} else {
phi_373_ = 0u;
}
let _e249 = phi_373_;
let _e256 = (bitcast<u32>((_e240 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e249 + _e242) < _e242)));
if (_e256 == 0u) {
} else {
let _e258 = (_e243 + 1u);
if (_e258 < _e29) {
let _e262 = atomicAdd((&global_2.member[_e258]), _e256);
}
}
}
}
}
phi_155_ = (_e98 + 1i);
phi_158_ = _e113;
} else {
phi_155_ = i32();
phi_158_ = u32();
}
let _e265 = phi_155_;
let _e267 = phi_158_;
continue;
continuing {
phi_154_ = _e265;
phi_157_ = _e267;
break if !(_e101);
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
