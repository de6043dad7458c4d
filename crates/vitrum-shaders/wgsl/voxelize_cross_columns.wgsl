struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_5 {
member: array<f32>,
}
struct type_8 {
member: array<u32>,
}
struct type_9 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
}
struct type_10 {
member: type_9,
}
struct type_13 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_10;
@group(0) @binding(3)
var<storage, read_write> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(1)
var<storage> global_4: type_5;
fn function_() {
var phi_143_: i32;
var phi_323_: i32;
var phi_590_: i32;
var phi_721_: i32;
var phi_722_: i32;
var phi_591_: i32;
var phi_324_: i32;
let _e27 = global;
let _e33 = arrayLength((&global_2.member));
let _e36 = global_1.member.member;
if (_e27.x < _e36.member) {
if (_e27.y < _e36.member_1) {
let _e46 = global_1.member.member.member;
let _e48 = ((_e27.y * _e46) + _e27.x);
let _e51 = global_1.member.member_1;
let _e53 = bitcast<i32>((_e48 * 3u));
let _e54 = (_e53 + 1i);
let _e56 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e58 = select(_e56, _e54, (_e54 < _e56));
let _e64 = global_3.member[bitcast<u32>(select(0i, _e58, (_e58 > 0i)))];
let _e65 = bitcast<i32>(_e64);
if (_e48 < _e51) {
let _e67 = (_e53 + 2i);
let _e69 = select(_e56, _e67, (_e67 < _e56));
let _e75 = global_3.member[bitcast<u32>(select(0i, _e69, (_e69 > 0i)))];
phi_143_ = bitcast<i32>(_e75);
} else {
phi_143_ = 0i;
}
let _e78 = phi_143_;
let _e80 = select(_e56, _e53, (_e53 < _e56));
let _e86 = global_3.member[bitcast<u32>(select(0i, _e80, (_e80 > 0i)))];
let _e89 = (bitcast<i32>(_e86) * 9i);
let _e91 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e93 = select(_e91, _e89, (_e89 < _e91));
let _e99 = global_4.member[bitcast<u32>(select(0i, _e93, (_e93 > 0i)))];
let _e100 = (_e89 + 1i);
let _e102 = select(_e91, _e100, (_e100 < _e91));
let _e108 = global_4.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e109 = (_e89 + 2i);
let _e111 = select(_e91, _e109, (_e109 < _e91));
let _e117 = global_4.member[bitcast<u32>(select(0i, _e111, (_e111 > 0i)))];
let _e118 = (_e89 + 3i);
let _e120 = select(_e91, _e118, (_e118 < _e91));
let _e126 = global_4.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e89 + 4i);
let _e129 = select(_e91, _e127, (_e127 < _e91));
let _e135 = global_4.member[bitcast<u32>(select(0i, _e129, (_e129 > 0i)))];
let _e136 = (_e89 + 5i);
let _e138 = select(_e91, _e136, (_e136 < _e91));
let _e144 = global_4.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e145 = (_e89 + 6i);
let _e147 = select(_e91, _e145, (_e145 < _e91));
let _e153 = global_4.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e154 = (_e89 + 7i);
let _e156 = select(_e91, _e154, (_e154 < _e91));
let _e162 = global_4.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e163 = (_e89 + 8i);
let _e165 = select(_e91, _e163, (_e163 < _e91));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e174 = global_1.member.member_4;
let _e175 = (_e174 & 31u);
let _e178 = f32((1u << bitcast<u32>(_e175)));
let _e179 = (1f / _e178);
let _e182 = global_1.member.member_6;
let _e186 = f32((1u << bitcast<u32>((_e182 & 31u))));
let _e190 = global_1.member.member_2.member;
let _e191 = f32(_e190);
phi_323_ = _e65;
loop {
let _e193 = phi_323_;
let _e194 = (_e193 < (_e65 + _e78));
if _e194 {
let _e197 = ((f32(_e193) + 0.5f) * _e179);
let _e198 = (_e117 <= _e197);
let _e199 = (_e144 > _e197);
let _e200 = (_e198 && _e199);
let _e201 = (_e144 <= _e197);
let _e202 = (_e117 > _e197);
let _e203 = (_e201 && _e202);
let _e204 = select(_e126, _e99, _e200);
let _e206 = select(_e135, _e108, _e200);
let _e208 = select(_e144, _e117, _e200);
let _e214 = ((_e197 - _e208) / select(1f, (select(_e117, _e144, _e200) - _e208), (_e200 || _e203)));
let _e217 = (_e204 + ((select(_e99, _e126, _e200) - _e204) * _e214));
let _e220 = (_e206 + ((select(_e108, _e135, _e200) - _e206) * _e214));
let _e221 = (_e171 > _e197);
let _e222 = (_e201 && _e221);
let _e223 = (_e171 <= _e197);
let _e224 = (_e223 && _e199);
let _e225 = select(_e153, _e126, _e222);
let _e227 = select(_e162, _e135, _e222);
let _e229 = select(_e171, _e144, _e222);
let _e235 = ((_e197 - _e229) / select(1f, (select(_e144, _e171, _e222) - _e229), (_e222 || _e224)));
let _e238 = (_e225 + ((select(_e126, _e153, _e222) - _e225) * _e235));
let _e241 = (_e227 + ((select(_e135, _e162, _e222) - _e227) * _e235));
let _e242 = (_e223 && _e202);
let _e244 = select(_e99, _e153, _e242);
let _e246 = select(_e108, _e162, _e242);
let _e248 = select(_e117, _e171, _e242);
let _e254 = ((_e197 - _e248) / select(1f, (select(_e171, _e117, _e242) - _e248), (_e242 || (_e198 && _e221))));
let _e257 = (_e244 + ((select(_e153, _e99, _e242) - _e244) * _e254));
let _e260 = (_e246 + ((select(_e162, _e108, _e242) - _e246) * _e254));
let _e264 = select(select(_e260, _e241, _e222), _e220, _e200);
let _e266 = select(select(_e257, _e238, _e224), _e217, _e203);
let _e268 = select(select(_e260, _e241, _e224), _e220, _e203);
let _e271 = (_e264 > _e268);
if ((_e200 || _e222) || _e242) {
let _e282 = global_1.member.member_2.member_1;
let _e287 = -(((select(_e268, _e264, _e271) * _e178) - 0.5f));
let _e288 = -((f32(_e282) * _e178));
let _e290 = select(_e288, _e287, (_e287 > _e288));
let _e292 = select(0f, _e290, (_e290 < 0f));
let _e299 = select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < -2147483600f)), 2147483647i, (_e292 > 2147483500f)), (_e292 == _e292));
let _e307 = -(((select(_e268, _e264, (_e264 < _e268)) * _e178) - 0.5f));
let _e309 = select(_e288, _e307, (_e307 > _e288));
let _e311 = select(0f, _e309, (_e309 < 0f));
let _e318 = select(0i, select(select(i32(_e311), i32(-2147483648), (_e311 < -2147483600f)), 2147483647i, (_e311 > 2147483500f)), (_e311 == _e311));
let _e328 = global_1.member.member_5;
phi_590_ = -((_e318 - select(0i, 1i, (_e311 < f32(_e318)))));
loop {
let _e332 = phi_590_;
let _e333 = (_e332 < -((_e299 - select(0i, 1i, (_e292 < f32(_e299))))));
if _e333 {
let _e338 = ((((f32(_e332) + 0.5f) * _e179) - _e268) * (1f / select((_e264 - _e268), 1f, (_e264 == _e268))));
let _e340 = select(0f, _e338, (_e338 > 0f));
let _e345 = (_e266 + ((select(select(_e257, _e238, _e222), _e217, _e200) - _e266) * select(1f, _e340, (_e340 < 1f))));
let _e347 = select(0f, _e345, (_e345 > 0f));
let _e349 = select(_e191, _e347, (_e347 < _e191));
let _e350 = (_e191 - 1f);
let _e352 = select(0f, _e349, (_e349 > 0f));
let _e354 = select(_e350, _e352, (_e352 < _e350));
let _e361 = select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < -2147483600f)), 2147483647i, (_e354 > 2147483500f)), (_e354 == _e354));
let _e365 = (_e361 - select(0i, 1i, (_e354 < f32(_e361))));
let _e367 = select(0f, _e186, (_e186 > 0f));
let _e369 = select(65536f, _e367, (_e367 < 65536f));
let _e376 = select(0i, select(select(i32(_e369), i32(-2147483648), (_e369 < -2147483600f)), 2147483647i, (_e369 > 2147483500f)), (_e369 == _e369));
let _e384 = (((_e349 - f32(_e365)) * _e186) + 0.5f);
let _e386 = select(0f, _e384, (_e384 > 0f));
let _e388 = select(_e186, _e386, (_e386 < _e186));
let _e395 = select(0i, select(select(i32(_e388), i32(-2147483648), (_e388 < -2147483600f)), 2147483647i, (_e388 > 2147483500f)), (_e388 == _e388));
let _e399 = (_e395 - select(0i, 1i, (_e388 < f32(_e395))));
let _e400 = ((_e376 - select(0i, 1i, (_e369 < f32(_e376)))) - _e399);
let _e408 = global_1.member.member_3;
let _e412 = bitcast<u32>(((((((_e193 >> bitcast<u32>(_e175)) - bitcast<i32>(_e328)) * bitcast<i32>(_e282)) + (_e332 >> bitcast<u32>(_e175))) * bitcast<i32>(_e408)) + _e365));
if _e271 {
phi_721_ = -(_e399);
phi_722_ = -(_e400);
} else {
phi_721_ = _e399;
phi_722_ = _e400;
}
let _e416 = phi_721_;
let _e418 = phi_722_;
if (_e418 == 0i) {
} else {
if (_e412 < _e33) {
let _e424 = atomicAdd((&global_2.member[_e412]), bitcast<u32>(_e418));
}
}
if (_e416 == 0i) {
} else {
let _e426 = (_e412 + 1u);
if (_e426 < _e33) {
let _e431 = atomicAdd((&global_2.member[_e426]), bitcast<u32>(_e416));
}
}
phi_591_ = (_e332 + 1i);
} else {
phi_591_ = i32();
}
let _e434 = phi_591_;
continue;
continuing {
phi_590_ = _e434;
break if !(_e333);
}
}
}
phi_324_ = (_e193 + 1i);
} else {
phi_324_ = i32();
}
let _e438 = phi_324_;
continue;
continuing {
phi_323_ = _e438;
break if !(_e194);
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
