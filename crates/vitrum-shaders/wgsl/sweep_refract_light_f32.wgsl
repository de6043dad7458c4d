struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_11 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_7,
member_21: f32,
member_22: f32,
member_23: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_33 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_24;
@group(0) @binding(4)
var<storage> global_3: type_24;
@group(0) @binding(6)
var<storage, read_write> global_4: type_26;
@group(0) @binding(3)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage> global_6: type_26;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: type_29;
var local_27: vec3<f32>;
var phi_898_: bool;
var phi_1078_: bool;
var phi_1081_: bool;
var phi_1265_: bool;
var phi_1588_: u32;
var phi_7051_: type_32;
var phi_7698_: type_33;
var phi_8532_: type_7;
var phi_12260_: type_35;
var phi_13579_: type_34;
var phi_13592_: vec3<f32>;
var phi_13593_: f32;
var phi_16209_: type_34;
var phi_16361_: vec3<f32>;
var phi_16362_: f32;
let _e155 = global;
let _e158 = arrayLength((&global_2.member));
let _e163 = arrayLength((&global_3.member));
let _e165 = arrayLength((&global_6.member));
let _e170 = global_1.member.member_2;
let _e173 = global_1.member.member;
let _e181 = (_e155.x + _e170.member);
let _e183 = (_e155.y + _e170.member_1);
if (_e181 < _e170.member_2) {
if (_e183 < _e170.member_3) {
let _e186 = (_e173.member * _e173.member_1);
let _e188 = ((_e183 * _e173.member) + _e181);
let _e189 = bitcast<i32>(_e188);
let _e191 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e193 = select(_e191, _e189, (_e189 < _e191));
let _e199 = global_4.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e200 = (_e186 + _e188);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e191, _e201, (_e201 < _e191));
let _e209 = global_4.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((2u * _e186) + _e188);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e191, _e212, (_e212 < _e191));
let _e220 = global_4.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((3u * _e186) + _e188);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e191, _e223, (_e223 < _e191));
let _e231 = global_4.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((4u * _e186) + _e188);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e191, _e234, (_e234 < _e191));
let _e242 = global_4.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((5u * _e186) + _e188);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e191, _e245, (_e245 < _e191));
let _e253 = global_4.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((6u * _e186) + _e188);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e191, _e256, (_e256 < _e191));
let _e264 = global_4.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((7u * _e186) + _e188);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e191, _e267, (_e267 < _e191));
let _e275 = global_4.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((8u * _e186) + _e188);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e191, _e278, (_e278 < _e191));
let _e286 = global_4.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e291 = global_1.member.member_10.member;
let _e295 = global_1.member.member_10.member_1;
let _e296 = (_e291 * _e295);
if (_e165 >= (_e296 * 4u)) {
let _e300 = bitcast<i32>((_e183 * _e291));
let _e302 = bitcast<i32>(_e181);
let _e307 = global_6.member[bitcast<u32>((_e300 + _e302))];
let _e313 = global_6.member[bitcast<u32>(((bitcast<i32>(_e296) + _e300) + _e302))];
let _e314 = f32(_e302);
let _e316 = f32(bitcast<i32>(_e183));
let _e322 = global_1.member.member_7.member;
let _e326 = global_1.member.member_10.member_8;
let _e327 = (_e322 - _e326);
let _e331 = global_1.member.member_10.member_2;
let _e335 = global_1.member.member_10.member_6;
let _e342 = global_1.member.member_10.member_4;
let _e344 = ((_e331 + (_e335 * _e327)) + (((_e314 - _e307) + 0.5f) * _e342));
let _e348 = global_1.member.member_10.member_3;
let _e352 = global_1.member.member_10.member_7;
let _e357 = ((_e348 + (_e352 * _e327)) + (((_e316 - _e313) + 0.5f) * _e342));
let _e361 = global_1.member.member_7.member_1;
let _e362 = (_e361 - _e326);
let _e367 = ((_e331 + (_e335 * _e362)) + ((_e314 + 0.5f) * _e342));
let _e372 = ((_e348 + (_e352 * _e362)) + ((_e316 + 0.5f) * _e342));
let _e378 = global_1.member.member_8.member.member;
let _e386 = (((_e378.member * _e378.member) + (_e378.member_1 * _e378.member_1)) + (_e378.member_2 * _e378.member_2));
let _e389 = sqrt(select(0f, _e386, (_e386 > 0f)));
let _e390 = ((1.5f * _e342) * _e389);
let _e394 = (select(1f, _e390, (_e390 < 1f)) + (1f / 64f));
let _e396 = select(_e394, 0.5f, (0.5f > _e394));
let _e400 = global_1.member.member_7.member_2;
let _e403 = (_e400 / select(1e-6f, _e253, (_e253 > 1e-6f)));
let _e407 = (_e367 + (_e231 * _e403));
let _e408 = (_e372 + (_e242 * _e403));
let _e409 = (_e361 + (_e253 * _e403));
let _e413 = global_1.member.member_8.member;
let _e424 = ((((_e413.member.member * _e344) + (_e413.member.member_1 * _e357)) + (_e413.member.member_2 * _e322)) + _e413.member_1);
let _e428 = global_1.member.member_8.member_1;
let _e439 = ((((_e428.member.member * _e344) + (_e428.member.member_1 * _e357)) + (_e428.member.member_2 * _e322)) + _e428.member_1);
let _e443 = global_1.member.member_8.member_2;
let _e454 = ((((_e443.member.member * _e344) + (_e443.member.member_1 * _e357)) + (_e443.member.member_2 * _e322)) + _e443.member_1);
let _e460 = ((((_e413.member.member * _e367) + (_e413.member.member_1 * _e372)) + (_e413.member.member_2 * _e361)) + _e413.member_1);
let _e466 = ((((_e428.member.member * _e367) + (_e428.member.member_1 * _e372)) + (_e428.member.member_2 * _e361)) + _e428.member_1);
let _e472 = ((((_e443.member.member * _e367) + (_e443.member.member_1 * _e372)) + (_e443.member.member_2 * _e361)) + _e443.member_1);
let _e478 = global_1.member.member_8.member_3.member;
let _e479 = (_e478 - 1f);
let _e488 = global_1.member.member_8.member_3.member_1;
let _e489 = (_e488 - 1f);
let _e498 = global_1.member.member_8.member_3.member_2;
let _e499 = (_e498 - 1f);
let _e513 = (((((((_e424 >= 0f) && (_e424 <= _e479)) && (_e439 >= 0f)) && (_e439 <= _e489)) && (_e454 >= 0f)) && (_e454 <= _e499)) && ((((((_e460 >= 0f) && (_e460 <= _e479)) && (_e466 >= 0f)) && (_e466 <= _e489)) && (_e472 >= 0f)) && (_e472 <= _e499)));
let _e522 = ((((_e173.member_2 == 1u) || (_e173.member_2 == 5u)) || (_e173.member_2 == 6u)) || ((_e173.member_2 == 2u) || (_e173.member_2 == 7u)));
if _e522 {
let _e523 = (_e396 - 0.5f);
let _e524 = (_e396 + 0.5f);
let _e526 = (_e478 - _e524);
let _e530 = (_e488 - _e524);
let _e535 = (_e498 - _e524);
let _e538 = ((((_e424 >= _e523) && (_e424 <= _e526)) && ((_e439 >= _e523) && (_e439 <= _e530))) && ((_e454 >= _e523) && (_e454 <= _e535)));
let _e541 = global_1.member.member_1;
let _e543 = ((_e541 & 16u) == 0u);
if _e543 {
phi_898_ = _e538;
} else {
let _e548 = global_1.member.member_16.member;
let _e560 = -((_e396 / _e389));
let _e565 = global_1.member.member_16.member_1;
let _e571 = global_1.member.member_17.member;
let _e587 = global_1.member.member_17.member_1;
let _e594 = global_1.member.member_18.member;
let _e610 = global_1.member.member_18.member_1;
let _e617 = global_1.member.member_19.member;
let _e633 = global_1.member.member_19.member_1;
phi_898_ = (_e538 && (((((((((_e548.member.member * _e344) + (_e548.member.member_1 * _e357)) + (_e548.member.member_2 * _e322)) + _e548.member_1) <= _e560) || (_e565 == 0u)) && ((((((_e571.member.member * _e344) + (_e571.member.member_1 * _e357)) + (_e571.member.member_2 * _e322)) + _e571.member_1) <= _e560) || (_e587 == 0u))) && ((((((_e594.member.member * _e344) + (_e594.member.member_1 * _e357)) + (_e594.member.member_2 * _e322)) + _e594.member_1) <= _e560) || (_e610 == 0u))) && ((((((_e617.member.member * _e344) + (_e617.member.member_1 * _e357)) + (_e617.member.member_2 * _e322)) + _e617.member_1) <= _e560) || (_e633 == 0u))));
}
let _e639 = phi_898_;
let _e643 = (_e367 + (_e367 - _e344));
let _e644 = (_e372 + (_e372 - _e357));
let _e645 = (_e361 + (_e361 - _e322));
let _e651 = ((((_e413.member.member * _e643) + (_e413.member.member_1 * _e644)) + (_e413.member.member_2 * _e645)) + _e413.member_1);
let _e657 = ((((_e428.member.member * _e643) + (_e428.member.member_1 * _e644)) + (_e428.member.member_2 * _e645)) + _e428.member_1);
let _e663 = ((((_e443.member.member * _e643) + (_e443.member.member_1 * _e644)) + (_e443.member.member_2 * _e645)) + _e443.member_1);
let _e674 = ((((_e651 >= _e523) && (_e651 <= _e526)) && ((_e657 >= _e523) && (_e657 <= _e530))) && ((_e663 >= _e523) && (_e663 <= _e535)));
if _e543 {
phi_1078_ = _e674;
} else {
let _e679 = global_1.member.member_16.member;
let _e691 = -((_e396 / _e389));
let _e696 = global_1.member.member_16.member_1;
let _e702 = global_1.member.member_17.member;
let _e718 = global_1.member.member_17.member_1;
let _e725 = global_1.member.member_18.member;
let _e741 = global_1.member.member_18.member_1;
let _e748 = global_1.member.member_19.member;
let _e764 = global_1.member.member_19.member_1;
phi_1078_ = (_e674 && (((((((((_e679.member.member * _e643) + (_e679.member.member_1 * _e644)) + (_e679.member.member_2 * _e645)) + _e679.member_1) <= _e691) || (_e696 == 0u)) && ((((((_e702.member.member * _e643) + (_e702.member.member_1 * _e644)) + (_e702.member.member_2 * _e645)) + _e702.member_1) <= _e691) || (_e718 == 0u))) && ((((((_e725.member.member * _e643) + (_e725.member.member_1 * _e644)) + (_e725.member.member_2 * _e645)) + _e725.member_1) <= _e691) || (_e741 == 0u))) && ((((((_e748.member.member * _e643) + (_e748.member.member_1 * _e644)) + (_e748.member.member_2 * _e645)) + _e748.member_1) <= _e691) || (_e764 == 0u))));
}
let _e770 = phi_1078_;
phi_1081_ = (_e513 && (_e639 && _e770));
} else {
phi_1081_ = _e513;
}
let _e774 = phi_1081_;
let _e781 = ((((_e413.member.member * _e407) + (_e413.member.member_1 * _e408)) + (_e413.member.member_2 * _e409)) + _e413.member_1);
let _e787 = ((((_e428.member.member * _e407) + (_e428.member.member_1 * _e408)) + (_e428.member.member_2 * _e409)) + _e428.member_1);
let _e793 = ((((_e443.member.member * _e407) + (_e443.member.member_1 * _e408)) + (_e443.member.member_2 * _e409)) + _e443.member_1);
let _e794 = (_e396 - 0.5f);
let _e795 = (_e396 + 0.5f);
let _e809 = ((((_e781 >= _e794) && (_e781 <= (_e478 - _e795))) && ((_e787 >= _e794) && (_e787 <= (_e488 - _e795)))) && ((_e793 >= _e794) && (_e793 <= (_e498 - _e795))));
let _e812 = global_1.member.member_1;
if ((_e812 & 16u) == 0u) {
phi_1265_ = _e809;
} else {
let _e819 = global_1.member.member_16.member;
let _e831 = -((_e396 / _e389));
let _e836 = global_1.member.member_16.member_1;
let _e842 = global_1.member.member_17.member;
let _e858 = global_1.member.member_17.member_1;
let _e865 = global_1.member.member_18.member;
let _e881 = global_1.member.member_18.member_1;
let _e888 = global_1.member.member_19.member;
let _e904 = global_1.member.member_19.member_1;
phi_1265_ = (_e809 && (((((((((_e819.member.member * _e407) + (_e819.member.member_1 * _e408)) + (_e819.member.member_2 * _e409)) + _e819.member_1) <= _e831) || (_e836 == 0u)) && ((((((_e842.member.member * _e407) + (_e842.member.member_1 * _e408)) + (_e842.member.member_2 * _e409)) + _e842.member_1) <= _e831) || (_e858 == 0u))) && ((((((_e865.member.member * _e407) + (_e865.member.member_1 * _e408)) + (_e865.member.member_2 * _e409)) + _e865.member_1) <= _e831) || (_e881 == 0u))) && ((((((_e888.member.member * _e407) + (_e888.member.member_1 * _e408)) + (_e888.member.member_2 * _e409)) + _e888.member_1) <= _e831) || (_e904 == 0u))));
}
let _e910 = phi_1265_;
let _e917 = global_1.member.member_8.member_4;
let _e918 = (_e478 - 0.5f);
let _e920 = select(-0.5f, _e460, (_e460 > -0.5f));
let _e922 = select(_e918, _e920, (_e920 < _e918));
let _e923 = (_e488 - 0.5f);
let _e925 = select(-0.5f, _e466, (_e466 > -0.5f));
let _e927 = select(_e923, _e925, (_e925 < _e923));
let _e928 = (_e498 - 0.5f);
let _e930 = select(-0.5f, _e472, (_e472 > -0.5f));
let _e932 = select(_e928, _e930, (_e930 < _e928));
let _e938 = bitcast<f32>((bitcast<u32>((_e460 - _e424)) & 2147483647u));
let _e941 = bitcast<f32>((bitcast<u32>((_e466 - _e439)) & 2147483647u));
let _e943 = select(_e941, _e938, (_e938 > _e941));
let _e946 = bitcast<f32>((bitcast<u32>((_e472 - _e454)) & 2147483647u));
let _e955 = bitcast<f32>((bitcast<u32>((_e460 - _e922)) & 2147483647u));
let _e958 = bitcast<f32>((bitcast<u32>((_e466 - _e927)) & 2147483647u));
let _e960 = select(_e958, _e955, (_e955 > _e958));
let _e963 = bitcast<f32>((bitcast<u32>((_e472 - _e932)) & 2147483647u));
let _e967 = (_e922 + 0.5f);
let _e969 = select(0f, _e967, (_e967 > 0f));
let _e971 = select(_e479, _e969, (_e969 < _e479));
let _e978 = select(0i, select(select(i32(_e971), i32(-2147483648), (_e971 < -2147483600f)), 2147483647i, (_e971 > 2147483500f)), (_e971 == _e971));
let _e986 = global_1.member.member_8.member_12;
let _e987 = (_e986 & 31u);
let _e990 = (_e927 + 0.5f);
let _e992 = select(0f, _e990, (_e990 > 0f));
let _e994 = select(_e489, _e992, (_e992 < _e489));
let _e1001 = select(0i, select(select(i32(_e994), i32(-2147483648), (_e994 < -2147483600f)), 2147483647i, (_e994 > 2147483500f)), (_e994 == _e994));
let _e1008 = (_e932 + 0.5f);
let _e1010 = select(0f, _e1008, (_e1008 > 0f));
let _e1012 = select(_e499, _e1010, (_e1010 < _e499));
let _e1019 = select(0i, select(select(i32(_e1012), i32(-2147483648), (_e1012 < -2147483600f)), 2147483647i, (_e1012 > 2147483500f)), (_e1012 == _e1012));
let _e1030 = global_1.member.member_8.member_9.member;
let _e1036 = global_1.member.member_8.member_9.member_1;
let _e1041 = global_1.member.member_8.member_10;
let _e1047 = ((bitcast<i32>(_e1041) + ((_e978 - select(0i, 1i, (_e971 < f32(_e978)))) >> bitcast<u32>(_e987))) + (bitcast<i32>(_e1030) * (((_e1001 - select(0i, 1i, (_e994 < f32(_e1001)))) >> bitcast<u32>(_e987)) + (bitcast<i32>(_e1036) * ((_e1019 - select(0i, 1i, (_e1012 < f32(_e1019)))) >> bitcast<u32>(_e987))))));
let _e1049 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1051 = select(_e1049, _e1047, (_e1047 < _e1049));
let _e1057 = global_5.member[bitcast<u32>(select(0i, _e1051, (_e1051 > 0i)))];
phi_1588_ = select(select(7u, 3u, (_e774 && (!(_e522) || _e910))), 1u, (((_e812 & 64u) != 0u) || ((((select(_e946, _e943, (_e943 > _e946)) <= _e917) && ((select(_e963, _e960, (_e960 > _e963)) > _e917) || (_e1057 != 0u))) && true) && ((_e812 & 32u) != 0u))));
} else {
phi_1588_ = 7u;
}
let _e1070 = phi_1588_;
if (_e1070 > 1u) {
let _e1075 = bitcast<i32>(((_e183 * _e291) + _e181));
let _e1078 = (bitcast<i32>(_e165) - 1i);
let _e1080 = select(_e1078, _e1075, (_e1075 < _e1078));
let _e1086 = global_6.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1087 = (bitcast<i32>(_e296) + _e1075);
let _e1089 = select(_e1078, _e1087, (_e1087 < _e1078));
let _e1095 = global_6.member[bitcast<u32>(select(0i, _e1089, (_e1089 > 0i)))];
let _e1097 = f32(bitcast<i32>(_e181));
let _e1099 = f32(bitcast<i32>(_e183));
let _e1105 = global_1.member.member_7.member;
let _e1109 = global_1.member.member_10.member_8;
let _e1110 = (_e1105 - _e1109);
let _e1114 = global_1.member.member_10.member_2;
let _e1118 = global_1.member.member_10.member_6;
let _e1125 = global_1.member.member_10.member_4;
let _e1127 = ((_e1114 + (_e1118 * _e1110)) + (((_e1097 - _e1086) + 0.5f) * _e1125));
let _e1131 = global_1.member.member_10.member_3;
let _e1135 = global_1.member.member_10.member_7;
let _e1140 = ((_e1131 + (_e1135 * _e1110)) + (((_e1099 - _e1095) + 0.5f) * _e1125));
let _e1144 = global_1.member.member_7.member_1;
let _e1145 = (_e1144 - _e1109);
let _e1150 = ((_e1114 + (_e1118 * _e1145)) + ((_e1097 + 0.5f) * _e1125));
let _e1155 = ((_e1131 + (_e1135 * _e1145)) + ((_e1099 + 0.5f) * _e1125));
let _e1159 = global_1.member.member_8.member;
let _e1170 = ((((_e1159.member.member * _e1127) + (_e1159.member.member_1 * _e1140)) + (_e1159.member.member_2 * _e1105)) + _e1159.member_1);
let _e1174 = global_1.member.member_8.member_1;
let _e1185 = ((((_e1174.member.member * _e1127) + (_e1174.member.member_1 * _e1140)) + (_e1174.member.member_2 * _e1105)) + _e1174.member_1);
let _e1189 = global_1.member.member_8.member_2;
let _e1200 = ((((_e1189.member.member * _e1127) + (_e1189.member.member_1 * _e1140)) + (_e1189.member.member_2 * _e1105)) + _e1189.member_1);
let _e1206 = ((((_e1159.member.member * _e1150) + (_e1159.member.member_1 * _e1155)) + (_e1159.member.member_2 * _e1144)) + _e1159.member_1);
let _e1212 = ((((_e1174.member.member * _e1150) + (_e1174.member.member_1 * _e1155)) + (_e1174.member.member_2 * _e1144)) + _e1174.member_1);
let _e1218 = ((((_e1189.member.member * _e1150) + (_e1189.member.member_1 * _e1155)) + (_e1189.member.member_2 * _e1144)) + _e1189.member_1);
let _e1220 = (_e173.member_2 == 5u);
let _e1226 = ((_e173.member_2 == 2u) || (_e173.member_2 == 7u));
let _e1227 = ((((_e173.member_2 == 1u) || _e1220) || (_e173.member_2 == 6u)) || _e1226);
if _e1227 {
let _e1232 = global_1.member.member_8.member_3.member;
let _e1233 = (_e1232 - 0.5f);
let _e1235 = select(-0.5f, _e1206, (_e1206 > -0.5f));
let _e1237 = select(_e1233, _e1235, (_e1235 < _e1233));
let _e1242 = global_1.member.member_8.member_3.member_1;
let _e1243 = (_e1242 - 0.5f);
let _e1245 = select(-0.5f, _e1212, (_e1212 > -0.5f));
let _e1247 = select(_e1243, _e1245, (_e1245 < _e1243));
let _e1252 = global_1.member.member_8.member_3.member_2;
let _e1253 = (_e1252 - 0.5f);
let _e1255 = select(-0.5f, _e1218, (_e1218 > -0.5f));
let _e1257 = select(_e1253, _e1255, (_e1255 < _e1253));
let _e1259 = select(-1f, _e1237, (_e1237 > -1f));
let _e1261 = select(_e1232, _e1259, (_e1259 < _e1232));
let _e1268 = select(0i, select(select(i32(_e1261), i32(-2147483648), (_e1261 < -2147483600f)), 2147483647i, (_e1261 > 2147483500f)), (_e1261 == _e1261));
let _e1272 = (_e1268 - select(0i, 1i, (_e1261 < f32(_e1268))));
let _e1274 = select(-1f, _e1247, (_e1247 > -1f));
let _e1276 = select(_e1242, _e1274, (_e1274 < _e1242));
let _e1283 = select(0i, select(select(i32(_e1276), i32(-2147483648), (_e1276 < -2147483600f)), 2147483647i, (_e1276 > 2147483500f)), (_e1276 == _e1276));
let _e1287 = (_e1283 - select(0i, 1i, (_e1276 < f32(_e1283))));
let _e1289 = select(-1f, _e1257, (_e1257 > -1f));
let _e1291 = select(_e1252, _e1289, (_e1289 < _e1252));
let _e1298 = select(0i, select(select(i32(_e1291), i32(-2147483648), (_e1291 < -2147483600f)), 2147483647i, (_e1291 > 2147483500f)), (_e1291 == _e1291));
let _e1302 = (_e1298 - select(0i, 1i, (_e1291 < f32(_e1298))));
let _e1306 = global_1.member.member_8.member_7;
let _e1310 = global_1.member.member_8.member_8;
let _e1318 = (select(0i, select(select(i32(_e1242), i32(-2147483648), (_e1242 < -2147483600f)), 2147483647i, (_e1242 > 2147483500f)), (_e1242 == _e1242)) - 1i);
let _e1319 = (_e1287 - 1i);
let _e1324 = (_e1287 + 1i);
let _e1327 = (_e1287 + 2i);
let _e1337 = (select(0i, select(select(i32(_e1252), i32(-2147483648), (_e1252 < -2147483600f)), 2147483647i, (_e1252 > 2147483500f)), (_e1252 == _e1252)) - 1i);
let _e1338 = (_e1302 - 1i);
let _e1343 = (_e1302 + 1i);
let _e1346 = (_e1302 + 2i);
let _e1356 = (select(0i, select(select(i32(_e1232), i32(-2147483648), (_e1232 < -2147483600f)), 2147483647i, (_e1232 > 2147483500f)), (_e1232 == _e1232)) - 1i);
let _e1357 = (_e1272 - 1i);
let _e1362 = (_e1272 + 1i);
let _e1365 = (_e1272 + 2i);
let _e1368 = (select(0i, _e1319, (_e1319 > 0i)) * _e1306);
let _e1369 = (select(0i, _e1287, (_e1287 > 0i)) * _e1306);
let _e1370 = (select(_e1318, _e1324, (_e1324 < _e1318)) * _e1306);
let _e1371 = (select(_e1318, _e1327, (_e1327 < _e1318)) * _e1306);
let _e1372 = (select(0i, _e1338, (_e1338 > 0i)) * _e1310);
let _e1373 = (select(0i, _e1302, (_e1302 > 0i)) * _e1310);
let _e1374 = (select(_e1337, _e1343, (_e1343 < _e1337)) * _e1310);
let _e1375 = (select(_e1337, _e1346, (_e1346 < _e1337)) * _e1310);
local_26 = type_29(array<i32, 4>(select(0i, _e1357, (_e1357 > 0i)), select(0i, _e1272, (_e1272 > 0i)), select(_e1356, _e1362, (_e1362 < _e1356)), select(_e1356, _e1365, (_e1365 < _e1356))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_27 = vec3<f32>((_e1237 - f32(_e1272)), (_e1247 - f32(_e1287)), (_e1257 - f32(_e1302)));
let _e1386 = (_e1373 + _e1369);
let _e1389 = local_26.member[0u];
let _e1390 = (_e1386 + _e1389);
let _e1392 = (bitcast<i32>(_e158) - 1i);
let _e1394 = select(_e1392, _e1390, (_e1390 < _e1392));
let _e1399 = global_2.member[bitcast<u32>(select(0i, _e1394, (_e1394 > 0i)))];
let _e1400 = bitcast<f32>(_e1399);
let _e1403 = local_26.member[1u];
let _e1404 = (_e1386 + _e1403);
let _e1406 = select(_e1392, _e1404, (_e1404 < _e1392));
let _e1411 = global_2.member[bitcast<u32>(select(0i, _e1406, (_e1406 > 0i)))];
let _e1412 = bitcast<f32>(_e1411);
let _e1415 = local_26.member[2u];
let _e1416 = (_e1386 + _e1415);
let _e1418 = select(_e1392, _e1416, (_e1416 < _e1392));
let _e1423 = global_2.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1424 = bitcast<f32>(_e1423);
let _e1427 = local_26.member[3u];
let _e1428 = (_e1386 + _e1427);
let _e1430 = select(_e1392, _e1428, (_e1428 < _e1392));
let _e1435 = global_2.member[bitcast<u32>(select(0i, _e1430, (_e1430 > 0i)))];
let _e1437 = local_27[0u];
let _e1440 = (_e1400 + ((_e1412 - _e1400) * _e1437));
let _e1441 = local_27[0u];
let _e1444 = (_e1412 + ((_e1424 - _e1412) * _e1441));
let _e1445 = local_27[0u];
let _e1448 = (_e1424 + ((bitcast<f32>(_e1435) - _e1424) * _e1445));
let _e1449 = (_e1373 + _e1370);
let _e1450 = local_26.member[0u];
let _e1451 = (_e1449 + _e1450);
let _e1453 = select(_e1392, _e1451, (_e1451 < _e1392));
let _e1458 = global_2.member[bitcast<u32>(select(0i, _e1453, (_e1453 > 0i)))];
let _e1459 = bitcast<f32>(_e1458);
let _e1460 = local_26.member[1u];
let _e1461 = (_e1449 + _e1460);
let _e1463 = select(_e1392, _e1461, (_e1461 < _e1392));
let _e1468 = global_2.member[bitcast<u32>(select(0i, _e1463, (_e1463 > 0i)))];
let _e1469 = bitcast<f32>(_e1468);
let _e1470 = local_26.member[2u];
let _e1471 = (_e1449 + _e1470);
let _e1473 = select(_e1392, _e1471, (_e1471 < _e1392));
let _e1478 = global_2.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1479 = bitcast<f32>(_e1478);
let _e1480 = local_26.member[3u];
let _e1481 = (_e1449 + _e1480);
let _e1483 = select(_e1392, _e1481, (_e1481 < _e1392));
let _e1488 = global_2.member[bitcast<u32>(select(0i, _e1483, (_e1483 > 0i)))];
let _e1490 = local_27[0u];
let _e1494 = local_27[0u];
let _e1497 = (_e1469 + ((_e1479 - _e1469) * _e1494));
let _e1498 = local_27[0u];
let _e1502 = (_e1374 + _e1369);
let _e1503 = local_26.member[0u];
let _e1504 = (_e1502 + _e1503);
let _e1506 = select(_e1392, _e1504, (_e1504 < _e1392));
let _e1511 = global_2.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1512 = bitcast<f32>(_e1511);
let _e1513 = local_26.member[1u];
let _e1514 = (_e1502 + _e1513);
let _e1516 = select(_e1392, _e1514, (_e1514 < _e1392));
let _e1521 = global_2.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1522 = bitcast<f32>(_e1521);
let _e1523 = local_26.member[2u];
let _e1524 = (_e1502 + _e1523);
let _e1526 = select(_e1392, _e1524, (_e1524 < _e1392));
let _e1531 = global_2.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1532 = bitcast<f32>(_e1531);
let _e1533 = local_26.member[3u];
let _e1534 = (_e1502 + _e1533);
let _e1536 = select(_e1392, _e1534, (_e1534 < _e1392));
let _e1541 = global_2.member[bitcast<u32>(select(0i, _e1536, (_e1536 > 0i)))];
let _e1543 = local_27[0u];
let _e1546 = (_e1512 + ((_e1522 - _e1512) * _e1543));
let _e1547 = local_27[0u];
let _e1550 = (_e1522 + ((_e1532 - _e1522) * _e1547));
let _e1551 = local_27[0u];
let _e1554 = (_e1532 + ((bitcast<f32>(_e1541) - _e1532) * _e1551));
let _e1555 = (_e1374 + _e1370);
let _e1556 = local_26.member[0u];
let _e1557 = (_e1555 + _e1556);
let _e1559 = select(_e1392, _e1557, (_e1557 < _e1392));
let _e1564 = global_2.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1565 = bitcast<f32>(_e1564);
let _e1566 = local_26.member[1u];
let _e1567 = (_e1555 + _e1566);
let _e1569 = select(_e1392, _e1567, (_e1567 < _e1392));
let _e1574 = global_2.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1575 = bitcast<f32>(_e1574);
let _e1576 = local_26.member[2u];
let _e1577 = (_e1555 + _e1576);
let _e1579 = select(_e1392, _e1577, (_e1577 < _e1392));
let _e1584 = global_2.member[bitcast<u32>(select(0i, _e1579, (_e1579 > 0i)))];
let _e1585 = bitcast<f32>(_e1584);
let _e1586 = local_26.member[3u];
let _e1587 = (_e1555 + _e1586);
let _e1589 = select(_e1392, _e1587, (_e1587 < _e1392));
let _e1594 = global_2.member[bitcast<u32>(select(0i, _e1589, (_e1589 > 0i)))];
let _e1596 = local_27[0u];
let _e1600 = local_27[0u];
let _e1603 = (_e1575 + ((_e1585 - _e1575) * _e1600));
let _e1604 = local_27[0u];
let _e1608 = (_e1373 + _e1368);
let _e1609 = local_26.member[1u];
let _e1610 = (_e1608 + _e1609);
let _e1612 = select(_e1392, _e1610, (_e1610 < _e1392));
let _e1617 = global_2.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1618 = bitcast<f32>(_e1617);
let _e1619 = local_26.member[2u];
let _e1620 = (_e1608 + _e1619);
let _e1622 = select(_e1392, _e1620, (_e1620 < _e1392));
let _e1627 = global_2.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1629 = local_27[0u];
let _e1632 = (_e1618 + ((bitcast<f32>(_e1627) - _e1618) * _e1629));
let _e1633 = (_e1373 + _e1371);
let _e1634 = local_26.member[1u];
let _e1635 = (_e1633 + _e1634);
let _e1637 = select(_e1392, _e1635, (_e1635 < _e1392));
let _e1642 = global_2.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1643 = bitcast<f32>(_e1642);
let _e1644 = local_26.member[2u];
let _e1645 = (_e1633 + _e1644);
let _e1647 = select(_e1392, _e1645, (_e1645 < _e1392));
let _e1652 = global_2.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1654 = local_27[0u];
let _e1658 = (_e1374 + _e1368);
let _e1659 = local_26.member[1u];
let _e1660 = (_e1658 + _e1659);
let _e1662 = select(_e1392, _e1660, (_e1660 < _e1392));
let _e1667 = global_2.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1668 = bitcast<f32>(_e1667);
let _e1669 = local_26.member[2u];
let _e1670 = (_e1658 + _e1669);
let _e1672 = select(_e1392, _e1670, (_e1670 < _e1392));
let _e1677 = global_2.member[bitcast<u32>(select(0i, _e1672, (_e1672 > 0i)))];
let _e1679 = local_27[0u];
let _e1682 = (_e1668 + ((bitcast<f32>(_e1677) - _e1668) * _e1679));
let _e1683 = (_e1374 + _e1371);
let _e1684 = local_26.member[1u];
let _e1685 = (_e1683 + _e1684);
let _e1687 = select(_e1392, _e1685, (_e1685 < _e1392));
let _e1692 = global_2.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1693 = bitcast<f32>(_e1692);
let _e1694 = local_26.member[2u];
let _e1695 = (_e1683 + _e1694);
let _e1697 = select(_e1392, _e1695, (_e1695 < _e1392));
let _e1702 = global_2.member[bitcast<u32>(select(0i, _e1697, (_e1697 > 0i)))];
let _e1704 = local_27[0u];
let _e1708 = (_e1372 + _e1369);
let _e1709 = local_26.member[1u];
let _e1710 = (_e1708 + _e1709);
let _e1712 = select(_e1392, _e1710, (_e1710 < _e1392));
let _e1717 = global_2.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1718 = bitcast<f32>(_e1717);
let _e1719 = local_26.member[2u];
let _e1720 = (_e1708 + _e1719);
let _e1722 = select(_e1392, _e1720, (_e1720 < _e1392));
let _e1727 = global_2.member[bitcast<u32>(select(0i, _e1722, (_e1722 > 0i)))];
let _e1729 = local_27[0u];
let _e1732 = (_e1718 + ((bitcast<f32>(_e1727) - _e1718) * _e1729));
let _e1733 = (_e1375 + _e1369);
let _e1734 = local_26.member[1u];
let _e1735 = (_e1733 + _e1734);
let _e1737 = select(_e1392, _e1735, (_e1735 < _e1392));
let _e1742 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1743 = bitcast<f32>(_e1742);
let _e1744 = local_26.member[2u];
let _e1745 = (_e1733 + _e1744);
let _e1747 = select(_e1392, _e1745, (_e1745 < _e1392));
let _e1752 = global_2.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1754 = local_27[0u];
let _e1757 = (_e1743 + ((bitcast<f32>(_e1752) - _e1743) * _e1754));
let _e1758 = (_e1372 + _e1370);
let _e1759 = local_26.member[1u];
let _e1760 = (_e1758 + _e1759);
let _e1762 = select(_e1392, _e1760, (_e1760 < _e1392));
let _e1767 = global_2.member[bitcast<u32>(select(0i, _e1762, (_e1762 > 0i)))];
let _e1768 = bitcast<f32>(_e1767);
let _e1769 = local_26.member[2u];
let _e1770 = (_e1758 + _e1769);
let _e1772 = select(_e1392, _e1770, (_e1770 < _e1392));
let _e1777 = global_2.member[bitcast<u32>(select(0i, _e1772, (_e1772 > 0i)))];
let _e1779 = local_27[0u];
let _e1783 = (_e1375 + _e1370);
let _e1784 = local_26.member[1u];
let _e1785 = (_e1783 + _e1784);
let _e1787 = select(_e1392, _e1785, (_e1785 < _e1392));
let _e1792 = global_2.member[bitcast<u32>(select(0i, _e1787, (_e1787 > 0i)))];
let _e1793 = bitcast<f32>(_e1792);
let _e1794 = local_26.member[2u];
let _e1795 = (_e1783 + _e1794);
let _e1797 = select(_e1392, _e1795, (_e1795 < _e1392));
let _e1802 = global_2.member[bitcast<u32>(select(0i, _e1797, (_e1797 > 0i)))];
let _e1804 = local_27[0u];
let _e1809 = local_27[1u];
let _e1812 = (_e1444 + ((_e1497 - _e1444) * _e1809));
let _e1813 = local_27[1u];
let _e1816 = (_e1550 + ((_e1603 - _e1550) * _e1813));
let _e1817 = local_27[1u];
let _e1820 = (_e1440 + (((_e1459 + ((_e1469 - _e1459) * _e1490)) - _e1440) * _e1817));
let _e1821 = local_27[1u];
let _e1826 = local_27[2u];
let _e1830 = local_27[1u];
let _e1833 = (_e1448 + (((_e1479 + ((bitcast<f32>(_e1488) - _e1479) * _e1498)) - _e1448) * _e1830));
let _e1834 = local_27[1u];
let _e1838 = local_27[2u];
let _e1842 = local_27[1u];
let _e1845 = (_e1632 + ((_e1444 - _e1632) * _e1842));
let _e1846 = local_27[1u];
let _e1850 = local_27[2u];
let _e1854 = local_27[1u];
let _e1857 = (_e1497 + (((_e1643 + ((bitcast<f32>(_e1652) - _e1643) * _e1654)) - _e1497) * _e1854));
let _e1858 = local_27[1u];
let _e1862 = local_27[2u];
let _e1866 = local_27[1u];
let _e1869 = (_e1732 + (((_e1768 + ((bitcast<f32>(_e1777) - _e1768) * _e1779)) - _e1732) * _e1866));
let _e1870 = local_27[2u];
let _e1874 = local_27[1u];
let _e1878 = local_27[2u];
let _e1882 = local_27[2u];
let _e1889 = global_1.member.member_8.member_6;
let _e1893 = global_1.member.member_8.member_5;
let _e1895 = (((_e1812 + ((_e1816 - _e1812) * _e1882)) - _e1889) * _e1893);
let _e1896 = -(1e9f);
let _e1898 = select(_e1896, _e1895, (_e1895 > _e1896));
let _e1900 = select(1e9f, _e1898, (_e1898 < 1e9f));
let _e1902 = (((_e1820 + (((_e1546 + (((_e1565 + ((_e1575 - _e1565) * _e1596)) - _e1546) * _e1821)) - _e1820) * _e1826)) - _e1889) * _e1893);
let _e1904 = select(_e1896, _e1902, (_e1902 > _e1896));
let _e1906 = select(1e9f, _e1904, (_e1904 < 1e9f));
let _e1908 = (((_e1833 + (((_e1554 + (((_e1585 + ((bitcast<f32>(_e1594) - _e1585) * _e1604)) - _e1554) * _e1834)) - _e1833) * _e1838)) - _e1889) * _e1893);
let _e1910 = select(_e1896, _e1908, (_e1908 > _e1896));
let _e1912 = select(1e9f, _e1910, (_e1910 < 1e9f));
let _e1914 = (((_e1845 + (((_e1682 + ((_e1550 - _e1682) * _e1846)) - _e1845) * _e1850)) - _e1889) * _e1893);
let _e1916 = select(_e1896, _e1914, (_e1914 > _e1896));
let _e1918 = select(1e9f, _e1916, (_e1916 < 1e9f));
let _e1920 = (((_e1857 + (((_e1603 + (((_e1693 + ((bitcast<f32>(_e1702) - _e1693) * _e1704)) - _e1603) * _e1858)) - _e1857) * _e1862)) - _e1889) * _e1893);
let _e1922 = select(_e1896, _e1920, (_e1920 > _e1896));
let _e1924 = select(1e9f, _e1922, (_e1922 < 1e9f));
let _e1926 = (((_e1869 + ((_e1812 - _e1869) * _e1870)) - _e1889) * _e1893);
let _e1928 = select(_e1896, _e1926, (_e1926 > _e1896));
let _e1930 = select(1e9f, _e1928, (_e1928 < 1e9f));
let _e1932 = (((_e1816 + (((_e1757 + (((_e1793 + ((bitcast<f32>(_e1802) - _e1793) * _e1804)) - _e1757) * _e1874)) - _e1816) * _e1878)) - _e1889) * _e1893);
let _e1934 = select(_e1896, _e1932, (_e1932 > _e1896));
let _e1936 = select(1e9f, _e1934, (_e1934 < 1e9f));
local_24 = _e1900;
let _e1937 = local_24;
local_25 = _e1937;
let _e1938 = local_25;
let _e1940 = (bitcast<i32>(_e163) - 1i);
let _e1942 = select(_e1940, 263197i, (263197i < _e1940));
let _e1947 = global_3.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1948 = bitcast<f32>(_e1947);
let _e1950 = select(_e1940, 263198i, (263198i < _e1940));
let _e1953 = bitcast<u32>(select(0i, _e1950, (_e1950 > 0i)));
let _e1955 = global_3.member[_e1953];
let _e1956 = bitcast<f32>(_e1955);
let _e1958 = select(_e1940, 263199i, (263199i < _e1940));
let _e1963 = global_3.member[bitcast<u32>(select(0i, _e1958, (_e1958 > 0i)))];
let _e1964 = bitcast<f32>(_e1963);
let _e1966 = ((_e1938 - _e1948) * _e1956);
let _e1968 = select(0f, _e1966, (_e1966 > 0f));
let _e1971 = local_25;
let _e1973 = select(_e1940, 263200i, (263200i < _e1940));
let _e1978 = global_3.member[bitcast<u32>(select(0i, _e1973, (_e1973 > 0i)))];
let _e1979 = bitcast<f32>(_e1978);
let _e1981 = select(_e1940, 263201i, (263201i < _e1940));
let _e1986 = global_3.member[bitcast<u32>(select(0i, _e1981, (_e1981 > 0i)))];
let _e1987 = bitcast<f32>(_e1986);
let _e1989 = select(_e1940, 263202i, (263202i < _e1940));
let _e1994 = global_3.member[bitcast<u32>(select(0i, _e1989, (_e1989 > 0i)))];
let _e1995 = bitcast<f32>(_e1994);
let _e1997 = ((_e1971 - _e1979) * _e1987);
let _e1999 = select(0f, _e1997, (_e1997 > 0f));
let _e2003 = local_25;
let _e2005 = select(_e1940, 263203i, (263203i < _e1940));
let _e2010 = global_3.member[bitcast<u32>(select(0i, _e2005, (_e2005 > 0i)))];
let _e2011 = bitcast<f32>(_e2010);
let _e2013 = select(_e1940, 263204i, (263204i < _e1940));
let _e2018 = global_3.member[bitcast<u32>(select(0i, _e2013, (_e2013 > 0i)))];
let _e2019 = bitcast<f32>(_e2018);
let _e2021 = select(_e1940, 263205i, (263205i < _e1940));
let _e2026 = global_3.member[bitcast<u32>(select(0i, _e2021, (_e2021 > 0i)))];
let _e2027 = bitcast<f32>(_e2026);
let _e2029 = ((_e2003 - _e2011) * _e2019);
let _e2031 = select(0f, _e2029, (_e2029 > 0f));
let _e2034 = local_25;
let _e2036 = select(_e1940, 263206i, (263206i < _e1940));
let _e2041 = global_3.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2042 = bitcast<f32>(_e2041);
let _e2044 = select(_e1940, 263207i, (263207i < _e1940));
let _e2049 = global_3.member[bitcast<u32>(select(0i, _e2044, (_e2044 > 0i)))];
let _e2050 = bitcast<f32>(_e2049);
let _e2052 = select(_e1940, 263208i, (263208i < _e1940));
let _e2057 = global_3.member[bitcast<u32>(select(0i, _e2052, (_e2052 > 0i)))];
let _e2058 = bitcast<f32>(_e2057);
let _e2060 = ((_e2034 - _e2042) * _e2050);
let _e2062 = select(0f, _e2060, (_e2060 > 0f));
let _e2066 = ((select(_e1964, _e1968, (_e1968 < _e1964)) + select(_e1995, _e1999, (_e1999 < _e1995))) + (select(_e2027, _e2031, (_e2031 < _e2027)) + select(_e2058, _e2062, (_e2062 < _e2058))));
let _e2068 = select(0f, _e2066, (_e2066 > 0f));
let _e2070 = select(1023f, _e2068, (_e2068 < 1023f));
let _e2077 = select(0i, select(select(i32(_e2070), i32(-2147483648), (_e2070 < -2147483600f)), 2147483647i, (_e2070 > 2147483500f)), (_e2070 == _e2070));
let _e2081 = (_e2077 - select(0i, 1i, (_e2070 < f32(_e2077))));
let _e2082 = (262147i + _e2081);
let _e2084 = select(_e1940, _e2082, (_e2082 < _e1940));
let _e2090 = global_3.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2100 = select(_e1940, 262146i, (262146i < _e1940));
let _e2106 = global_3.member[bitcast<u32>(select(0i, _e2100, (_e2100 > 0i)))];
let _e2107 = bitcast<f32>(_e2106);
let _e2108 = (f32((bitcast<i32>((_e2090 & 4095u)) - 2048i)) * _e2107);
let _e2110 = select(_e1940, 262144i, (262144i < _e1940));
let _e2116 = global_3.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2117 = bitcast<f32>(_e2116);
let _e2119 = select(_e1940, 262145i, (262145i < _e1940));
let _e2125 = global_3.member[bitcast<u32>(select(0i, _e2119, (_e2119 > 0i)))];
let _e2126 = bitcast<f32>(_e2125);
let _e2132 = ((_e2117 + (f32(bitcast<i32>((_e2090 >> bitcast<u32>(12u)))) * _e2126)) + (_e2108 * (_e2066 - f32(_e2081))));
let _e2135 = global_3.member[_e1953];
let _e2137 = local_24;
let _e2140 = local_24;
let _e2143 = local_24;
let _e2147 = select(_e1940, 263209i, (263209i < _e1940));
let _e2153 = global_3.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2155 = local_24;
let _e2158 = select(_e1940, 263210i, (263210i < _e1940));
let _e2164 = global_3.member[bitcast<u32>(select(0i, _e2158, (_e2158 > 0i)))];
let _e2166 = local_24;
let _e2170 = (_e2108 * select(0f, select(select(select(bitcast<f32>(_e2135), _e1987, (_e2137 >= _e1979)), _e2019, (_e2140 >= _e2011)), _e2050, (_e2143 >= _e2042)), ((_e2155 >= bitcast<f32>(_e2153)) && (_e2166 <= bitcast<f32>(_e2164)))));
if _e1226 {
let _e2177 = ((0.5f * (_e1912 - _e1906)) * _e2170);
let _e2178 = ((0.5f * (_e1924 - _e1918)) * _e2170);
let _e2179 = ((0.5f * (_e1936 - _e1930)) * _e2170);
phi_7051_ = type_32(_e2132, vec3<f32>(_e2177, _e2178, _e2179), vec3<f32>((_e2177 * _e2132), (_e2178 * _e2132), (_e2179 * _e2132)));
} else {
local_22 = _e1906;
let _e2186 = local_22;
local_23 = _e2186;
let _e2187 = local_23;
let _e2189 = ((_e2187 - _e1948) * _e1956);
let _e2191 = select(0f, _e2189, (_e2189 > 0f));
let _e2194 = local_23;
let _e2196 = ((_e2194 - _e1979) * _e1987);
let _e2198 = select(0f, _e2196, (_e2196 > 0f));
let _e2202 = local_23;
let _e2204 = ((_e2202 - _e2011) * _e2019);
let _e2206 = select(0f, _e2204, (_e2204 > 0f));
let _e2209 = local_23;
let _e2211 = ((_e2209 - _e2042) * _e2050);
let _e2213 = select(0f, _e2211, (_e2211 > 0f));
let _e2217 = ((select(_e1964, _e2191, (_e2191 < _e1964)) + select(_e1995, _e2198, (_e2198 < _e1995))) + (select(_e2027, _e2206, (_e2206 < _e2027)) + select(_e2058, _e2213, (_e2213 < _e2058))));
let _e2219 = select(0f, _e2217, (_e2217 > 0f));
let _e2221 = select(1023f, _e2219, (_e2219 < 1023f));
let _e2228 = select(0i, select(select(i32(_e2221), i32(-2147483648), (_e2221 < -2147483600f)), 2147483647i, (_e2221 > 2147483500f)), (_e2221 == _e2221));
let _e2232 = (_e2228 - select(0i, 1i, (_e2221 < f32(_e2228))));
let _e2233 = (262147i + _e2232);
let _e2235 = select(_e1940, _e2233, (_e2233 < _e1940));
let _e2241 = global_3.member[bitcast<u32>(select(0i, _e2235, (_e2235 > 0i)))];
let _e2256 = ((_e2117 + (f32(bitcast<i32>((_e2241 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2241 & 4095u)) - 2048i)) * _e2107) * (_e2217 - f32(_e2232))));
local_20 = _e1912;
let _e2257 = local_20;
local_21 = _e2257;
let _e2258 = local_21;
let _e2260 = ((_e2258 - _e1948) * _e1956);
let _e2262 = select(0f, _e2260, (_e2260 > 0f));
let _e2265 = local_21;
let _e2267 = ((_e2265 - _e1979) * _e1987);
let _e2269 = select(0f, _e2267, (_e2267 > 0f));
let _e2273 = local_21;
let _e2275 = ((_e2273 - _e2011) * _e2019);
let _e2277 = select(0f, _e2275, (_e2275 > 0f));
let _e2280 = local_21;
let _e2282 = ((_e2280 - _e2042) * _e2050);
let _e2284 = select(0f, _e2282, (_e2282 > 0f));
let _e2288 = ((select(_e1964, _e2262, (_e2262 < _e1964)) + select(_e1995, _e2269, (_e2269 < _e1995))) + (select(_e2027, _e2277, (_e2277 < _e2027)) + select(_e2058, _e2284, (_e2284 < _e2058))));
let _e2290 = select(0f, _e2288, (_e2288 > 0f));
let _e2292 = select(1023f, _e2290, (_e2290 < 1023f));
let _e2299 = select(0i, select(select(i32(_e2292), i32(-2147483648), (_e2292 < -2147483600f)), 2147483647i, (_e2292 > 2147483500f)), (_e2292 == _e2292));
let _e2303 = (_e2299 - select(0i, 1i, (_e2292 < f32(_e2299))));
let _e2304 = (262147i + _e2303);
let _e2306 = select(_e1940, _e2304, (_e2304 < _e1940));
let _e2312 = global_3.member[bitcast<u32>(select(0i, _e2306, (_e2306 > 0i)))];
let _e2327 = ((_e2117 + (f32(bitcast<i32>((_e2312 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2312 & 4095u)) - 2048i)) * _e2107) * (_e2288 - f32(_e2303))));
local_18 = _e1918;
let _e2328 = local_18;
local_19 = _e2328;
let _e2329 = local_19;
let _e2331 = ((_e2329 - _e1948) * _e1956);
let _e2333 = select(0f, _e2331, (_e2331 > 0f));
let _e2336 = local_19;
let _e2338 = ((_e2336 - _e1979) * _e1987);
let _e2340 = select(0f, _e2338, (_e2338 > 0f));
let _e2344 = local_19;
let _e2346 = ((_e2344 - _e2011) * _e2019);
let _e2348 = select(0f, _e2346, (_e2346 > 0f));
let _e2351 = local_19;
let _e2353 = ((_e2351 - _e2042) * _e2050);
let _e2355 = select(0f, _e2353, (_e2353 > 0f));
let _e2359 = ((select(_e1964, _e2333, (_e2333 < _e1964)) + select(_e1995, _e2340, (_e2340 < _e1995))) + (select(_e2027, _e2348, (_e2348 < _e2027)) + select(_e2058, _e2355, (_e2355 < _e2058))));
let _e2361 = select(0f, _e2359, (_e2359 > 0f));
let _e2363 = select(1023f, _e2361, (_e2361 < 1023f));
let _e2370 = select(0i, select(select(i32(_e2363), i32(-2147483648), (_e2363 < -2147483600f)), 2147483647i, (_e2363 > 2147483500f)), (_e2363 == _e2363));
let _e2374 = (_e2370 - select(0i, 1i, (_e2363 < f32(_e2370))));
let _e2375 = (262147i + _e2374);
let _e2377 = select(_e1940, _e2375, (_e2375 < _e1940));
let _e2383 = global_3.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2398 = ((_e2117 + (f32(bitcast<i32>((_e2383 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2383 & 4095u)) - 2048i)) * _e2107) * (_e2359 - f32(_e2374))));
local_16 = _e1924;
let _e2399 = local_16;
local_17 = _e2399;
let _e2400 = local_17;
let _e2402 = ((_e2400 - _e1948) * _e1956);
let _e2404 = select(0f, _e2402, (_e2402 > 0f));
let _e2407 = local_17;
let _e2409 = ((_e2407 - _e1979) * _e1987);
let _e2411 = select(0f, _e2409, (_e2409 > 0f));
let _e2415 = local_17;
let _e2417 = ((_e2415 - _e2011) * _e2019);
let _e2419 = select(0f, _e2417, (_e2417 > 0f));
let _e2422 = local_17;
let _e2424 = ((_e2422 - _e2042) * _e2050);
let _e2426 = select(0f, _e2424, (_e2424 > 0f));
let _e2430 = ((select(_e1964, _e2404, (_e2404 < _e1964)) + select(_e1995, _e2411, (_e2411 < _e1995))) + (select(_e2027, _e2419, (_e2419 < _e2027)) + select(_e2058, _e2426, (_e2426 < _e2058))));
let _e2432 = select(0f, _e2430, (_e2430 > 0f));
let _e2434 = select(1023f, _e2432, (_e2432 < 1023f));
let _e2441 = select(0i, select(select(i32(_e2434), i32(-2147483648), (_e2434 < -2147483600f)), 2147483647i, (_e2434 > 2147483500f)), (_e2434 == _e2434));
let _e2445 = (_e2441 - select(0i, 1i, (_e2434 < f32(_e2441))));
let _e2446 = (262147i + _e2445);
let _e2448 = select(_e1940, _e2446, (_e2446 < _e1940));
let _e2454 = global_3.member[bitcast<u32>(select(0i, _e2448, (_e2448 > 0i)))];
let _e2469 = ((_e2117 + (f32(bitcast<i32>((_e2454 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2454 & 4095u)) - 2048i)) * _e2107) * (_e2430 - f32(_e2445))));
local_14 = _e1930;
let _e2470 = local_14;
local_15 = _e2470;
let _e2471 = local_15;
let _e2473 = ((_e2471 - _e1948) * _e1956);
let _e2475 = select(0f, _e2473, (_e2473 > 0f));
let _e2478 = local_15;
let _e2480 = ((_e2478 - _e1979) * _e1987);
let _e2482 = select(0f, _e2480, (_e2480 > 0f));
let _e2486 = local_15;
let _e2488 = ((_e2486 - _e2011) * _e2019);
let _e2490 = select(0f, _e2488, (_e2488 > 0f));
let _e2493 = local_15;
let _e2495 = ((_e2493 - _e2042) * _e2050);
let _e2497 = select(0f, _e2495, (_e2495 > 0f));
let _e2501 = ((select(_e1964, _e2475, (_e2475 < _e1964)) + select(_e1995, _e2482, (_e2482 < _e1995))) + (select(_e2027, _e2490, (_e2490 < _e2027)) + select(_e2058, _e2497, (_e2497 < _e2058))));
let _e2503 = select(0f, _e2501, (_e2501 > 0f));
let _e2505 = select(1023f, _e2503, (_e2503 < 1023f));
let _e2512 = select(0i, select(select(i32(_e2505), i32(-2147483648), (_e2505 < -2147483600f)), 2147483647i, (_e2505 > 2147483500f)), (_e2505 == _e2505));
let _e2516 = (_e2512 - select(0i, 1i, (_e2505 < f32(_e2512))));
let _e2517 = (262147i + _e2516);
let _e2519 = select(_e1940, _e2517, (_e2517 < _e1940));
let _e2525 = global_3.member[bitcast<u32>(select(0i, _e2519, (_e2519 > 0i)))];
let _e2540 = ((_e2117 + (f32(bitcast<i32>((_e2525 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2525 & 4095u)) - 2048i)) * _e2107) * (_e2501 - f32(_e2516))));
local_12 = _e1936;
let _e2541 = local_12;
local_13 = _e2541;
let _e2542 = local_13;
let _e2544 = ((_e2542 - _e1948) * _e1956);
let _e2546 = select(0f, _e2544, (_e2544 > 0f));
let _e2549 = local_13;
let _e2551 = ((_e2549 - _e1979) * _e1987);
let _e2553 = select(0f, _e2551, (_e2551 > 0f));
let _e2557 = local_13;
let _e2559 = ((_e2557 - _e2011) * _e2019);
let _e2561 = select(0f, _e2559, (_e2559 > 0f));
let _e2564 = local_13;
let _e2566 = ((_e2564 - _e2042) * _e2050);
let _e2568 = select(0f, _e2566, (_e2566 > 0f));
let _e2572 = ((select(_e1964, _e2546, (_e2546 < _e1964)) + select(_e1995, _e2553, (_e2553 < _e1995))) + (select(_e2027, _e2561, (_e2561 < _e2027)) + select(_e2058, _e2568, (_e2568 < _e2058))));
let _e2574 = select(0f, _e2572, (_e2572 > 0f));
let _e2576 = select(1023f, _e2574, (_e2574 < 1023f));
let _e2583 = select(0i, select(select(i32(_e2576), i32(-2147483648), (_e2576 < -2147483600f)), 2147483647i, (_e2576 > 2147483500f)), (_e2576 == _e2576));
let _e2587 = (_e2583 - select(0i, 1i, (_e2576 < f32(_e2583))));
let _e2588 = (262147i + _e2587);
let _e2590 = select(_e1940, _e2588, (_e2588 < _e1940));
let _e2596 = global_3.member[bitcast<u32>(select(0i, _e2590, (_e2590 > 0i)))];
let _e2611 = ((_e2117 + (f32(bitcast<i32>((_e2596 >> bitcast<u32>(12u)))) * _e2126)) + ((f32((bitcast<i32>((_e2596 & 4095u)) - 2048i)) * _e2107) * (_e2572 - f32(_e2587))));
let _e2612 = (_e2327 - _e2256);
let _e2614 = (_e2469 - _e2398);
let _e2616 = (_e2611 - _e2540);
phi_7051_ = type_32(_e2132, vec3<f32>((0.5f * _e2612), (0.5f * _e2614), (0.5f * _e2616)), vec3<f32>((0.25f * (_e2612 * (_e2327 + _e2256))), (0.25f * (_e2614 * (_e2469 + _e2398))), (0.25f * (_e2616 * (_e2611 + _e2540)))));
}
let _e2631 = phi_7051_;
let _e2646 = select(0f, 1f, ((((((_e1206 >= -0.5f) && (_e1206 <= _e1233)) && (_e1212 >= -0.5f)) && (_e1212 <= _e1243)) && (_e1218 >= -0.5f)) && (_e1218 <= _e1253)));
let _e2648 = (0.5f * (_e1912 - _e1906));
let _e2650 = (0.5f * (_e1924 - _e1918));
let _e2652 = (0.5f * (_e1936 - _e1930));
let _e2658 = global_1.member.member_8.member.member.member;
let _e2664 = global_1.member.member_8.member.member.member_1;
let _e2670 = global_1.member.member_8.member.member.member_2;
let _e2676 = global_1.member.member_8.member_1.member.member;
let _e2682 = global_1.member.member_8.member_1.member.member_1;
let _e2688 = global_1.member.member_8.member_1.member.member_2;
let _e2694 = global_1.member.member_8.member_2.member.member;
let _e2700 = global_1.member.member_8.member_2.member.member_1;
let _e2706 = global_1.member.member_8.member_2.member.member_2;
phi_7698_ = type_33(_e1900, vec3<f32>(((((_e2658 * _e2648) + (_e2676 * _e2650)) + (_e2694 * _e2652)) * _e2646), ((((_e2664 * _e2648) + (_e2682 * _e2650)) + (_e2700 * _e2652)) * _e2646), ((((_e2670 * _e2648) + (_e2688 * _e2650)) + (_e2706 * _e2652)) * _e2646)), _e2631.member, vec3<f32>(((((_e2658 * _e2631.member_2.x) + (_e2676 * _e2631.member_2.y)) + (_e2694 * _e2631.member_2.z)) * _e2646), ((((_e2664 * _e2631.member_2.x) + (_e2682 * _e2631.member_2.y)) + (_e2700 * _e2631.member_2.z)) * _e2646), ((((_e2670 * _e2631.member_2.x) + (_e2688 * _e2631.member_2.y)) + (_e2706 * _e2631.member_2.z)) * _e2646)), vec3<f32>(((((_e2658 * _e2631.member_1.x) + (_e2676 * _e2631.member_1.y)) + (_e2694 * _e2631.member_1.z)) * _e2646), ((((_e2664 * _e2631.member_1.x) + (_e2682 * _e2631.member_1.y)) + (_e2700 * _e2631.member_1.z)) * _e2646), ((((_e2670 * _e2631.member_1.x) + (_e2688 * _e2631.member_1.y)) + (_e2706 * _e2631.member_1.z)) * _e2646)));
} else {
let _e2775 = global_1.member.member_8.member_3.member;
let _e2776 = (_e2775 - 0.5f);
let _e2778 = select(-0.5f, _e1206, (_e1206 > -0.5f));
let _e2780 = select(_e2776, _e2778, (_e2778 < _e2776));
let _e2785 = global_1.member.member_8.member_3.member_1;
let _e2786 = (_e2785 - 0.5f);
let _e2788 = select(-0.5f, _e1212, (_e1212 > -0.5f));
let _e2790 = select(_e2786, _e2788, (_e2788 < _e2786));
let _e2795 = global_1.member.member_8.member_3.member_2;
let _e2796 = (_e2795 - 0.5f);
let _e2798 = select(-0.5f, _e1218, (_e1218 > -0.5f));
let _e2800 = select(_e2796, _e2798, (_e2798 < _e2796));
let _e2802 = select(-1f, _e2780, (_e2780 > -1f));
let _e2804 = select(_e2775, _e2802, (_e2802 < _e2775));
let _e2811 = select(0i, select(select(i32(_e2804), i32(-2147483648), (_e2804 < -2147483600f)), 2147483647i, (_e2804 > 2147483500f)), (_e2804 == _e2804));
let _e2815 = (_e2811 - select(0i, 1i, (_e2804 < f32(_e2811))));
let _e2817 = select(-1f, _e2790, (_e2790 > -1f));
let _e2819 = select(_e2785, _e2817, (_e2817 < _e2785));
let _e2826 = select(0i, select(select(i32(_e2819), i32(-2147483648), (_e2819 < -2147483600f)), 2147483647i, (_e2819 > 2147483500f)), (_e2819 == _e2819));
let _e2830 = (_e2826 - select(0i, 1i, (_e2819 < f32(_e2826))));
let _e2832 = select(-1f, _e2800, (_e2800 > -1f));
let _e2834 = select(_e2795, _e2832, (_e2832 < _e2795));
let _e2841 = select(0i, select(select(i32(_e2834), i32(-2147483648), (_e2834 < -2147483600f)), 2147483647i, (_e2834 > 2147483500f)), (_e2834 == _e2834));
let _e2845 = (_e2841 - select(0i, 1i, (_e2834 < f32(_e2841))));
let _e2849 = global_1.member.member_8.member_7;
let _e2853 = global_1.member.member_8.member_8;
let _e2861 = (select(0i, select(select(i32(_e2785), i32(-2147483648), (_e2785 < -2147483600f)), 2147483647i, (_e2785 > 2147483500f)), (_e2785 == _e2785)) - 1i);
let _e2864 = (_e2830 + 1i);
let _e2874 = (select(0i, select(select(i32(_e2795), i32(-2147483648), (_e2795 < -2147483600f)), 2147483647i, (_e2795 > 2147483500f)), (_e2795 == _e2795)) - 1i);
let _e2877 = (_e2845 + 1i);
let _e2887 = (select(0i, select(select(i32(_e2775), i32(-2147483648), (_e2775 < -2147483600f)), 2147483647i, (_e2775 > 2147483500f)), (_e2775 == _e2775)) - 1i);
let _e2888 = (_e2815 - 1i);
let _e2893 = (_e2815 + 1i);
let _e2896 = (_e2815 + 2i);
let _e2899 = (select(0i, _e2830, (_e2830 > 0i)) * _e2849);
let _e2900 = (select(_e2861, _e2864, (_e2864 < _e2861)) * _e2849);
let _e2901 = (select(0i, _e2845, (_e2845 > 0i)) * _e2853);
let _e2902 = (select(_e2874, _e2877, (_e2877 < _e2874)) * _e2853);
local_10 = type_29(array<i32, 4>(select(0i, _e2888, (_e2888 > 0i)), select(0i, _e2815, (_e2815 > 0i)), select(_e2887, _e2893, (_e2893 < _e2887)), select(_e2887, _e2896, (_e2896 < _e2887))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = vec3<f32>((_e2780 - f32(_e2815)), (_e2790 - f32(_e2830)), (_e2800 - f32(_e2845)));
let _e2913 = (_e2901 + _e2899);
let _e2916 = local_10.member[1u];
let _e2917 = (_e2913 + _e2916);
let _e2919 = (bitcast<i32>(_e158) - 1i);
let _e2921 = select(_e2919, _e2917, (_e2917 < _e2919));
let _e2926 = global_2.member[bitcast<u32>(select(0i, _e2921, (_e2921 > 0i)))];
let _e2927 = bitcast<f32>(_e2926);
let _e2930 = local_10.member[2u];
let _e2931 = (_e2913 + _e2930);
let _e2933 = select(_e2919, _e2931, (_e2931 < _e2919));
let _e2938 = global_2.member[bitcast<u32>(select(0i, _e2933, (_e2933 > 0i)))];
let _e2940 = local_11[0u];
let _e2943 = (_e2927 + ((bitcast<f32>(_e2938) - _e2927) * _e2940));
let _e2944 = (_e2901 + _e2900);
let _e2945 = local_10.member[1u];
let _e2946 = (_e2944 + _e2945);
let _e2948 = select(_e2919, _e2946, (_e2946 < _e2919));
let _e2953 = global_2.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2954 = bitcast<f32>(_e2953);
let _e2955 = local_10.member[2u];
let _e2956 = (_e2944 + _e2955);
let _e2958 = select(_e2919, _e2956, (_e2956 < _e2919));
let _e2963 = global_2.member[bitcast<u32>(select(0i, _e2958, (_e2958 > 0i)))];
let _e2965 = local_11[0u];
let _e2970 = local_11[1u];
let _e2973 = (_e2943 + (((_e2954 + ((bitcast<f32>(_e2963) - _e2954) * _e2965)) - _e2943) * _e2970));
let _e2974 = (_e2902 + _e2899);
let _e2975 = local_10.member[1u];
let _e2976 = (_e2974 + _e2975);
let _e2978 = select(_e2919, _e2976, (_e2976 < _e2919));
let _e2983 = global_2.member[bitcast<u32>(select(0i, _e2978, (_e2978 > 0i)))];
let _e2984 = bitcast<f32>(_e2983);
let _e2985 = local_10.member[2u];
let _e2986 = (_e2974 + _e2985);
let _e2988 = select(_e2919, _e2986, (_e2986 < _e2919));
let _e2993 = global_2.member[bitcast<u32>(select(0i, _e2988, (_e2988 > 0i)))];
let _e2995 = local_11[0u];
let _e2998 = (_e2984 + ((bitcast<f32>(_e2993) - _e2984) * _e2995));
let _e2999 = (_e2902 + _e2900);
let _e3000 = local_10.member[1u];
let _e3001 = (_e2999 + _e3000);
let _e3003 = select(_e2919, _e3001, (_e3001 < _e2919));
let _e3008 = global_2.member[bitcast<u32>(select(0i, _e3003, (_e3003 > 0i)))];
let _e3009 = bitcast<f32>(_e3008);
let _e3010 = local_10.member[2u];
let _e3011 = (_e2999 + _e3010);
let _e3013 = select(_e2919, _e3011, (_e3011 < _e2919));
let _e3018 = global_2.member[bitcast<u32>(select(0i, _e3013, (_e3013 > 0i)))];
let _e3020 = local_11[0u];
let _e3024 = local_11[1u];
let _e3029 = local_11[2u];
let _e3036 = global_1.member.member_8.member_6;
let _e3040 = global_1.member.member_8.member_5;
let _e3042 = (((_e2973 + (((_e2998 + (((_e3009 + ((bitcast<f32>(_e3018) - _e3009) * _e3020)) - _e2998) * _e3024)) - _e2973) * _e3029)) - _e3036) * _e3040);
let _e3043 = -(1e9f);
let _e3045 = select(_e3043, _e3042, (_e3042 > _e3043));
phi_7698_ = type_33(select(1e9f, _e3045, (_e3045 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3050 = phi_7698_;
let _e3055 = global_1.member.member_8.member_3.member;
let _e3056 = (_e3055 - 0.5f);
let _e3058 = select(-0.5f, _e1170, (_e1170 > -0.5f));
let _e3060 = select(_e3056, _e3058, (_e3058 < _e3056));
let _e3065 = global_1.member.member_8.member_3.member_1;
let _e3066 = (_e3065 - 0.5f);
let _e3068 = select(-0.5f, _e1185, (_e1185 > -0.5f));
let _e3070 = select(_e3066, _e3068, (_e3068 < _e3066));
let _e3075 = global_1.member.member_8.member_3.member_2;
let _e3076 = (_e3075 - 0.5f);
let _e3078 = select(-0.5f, _e1200, (_e1200 > -0.5f));
let _e3080 = select(_e3076, _e3078, (_e3078 < _e3076));
let _e3082 = select(-1f, _e3060, (_e3060 > -1f));
let _e3084 = select(_e3055, _e3082, (_e3082 < _e3055));
let _e3091 = select(0i, select(select(i32(_e3084), i32(-2147483648), (_e3084 < -2147483600f)), 2147483647i, (_e3084 > 2147483500f)), (_e3084 == _e3084));
let _e3095 = (_e3091 - select(0i, 1i, (_e3084 < f32(_e3091))));
let _e3097 = select(-1f, _e3070, (_e3070 > -1f));
let _e3099 = select(_e3065, _e3097, (_e3097 < _e3065));
let _e3106 = select(0i, select(select(i32(_e3099), i32(-2147483648), (_e3099 < -2147483600f)), 2147483647i, (_e3099 > 2147483500f)), (_e3099 == _e3099));
let _e3110 = (_e3106 - select(0i, 1i, (_e3099 < f32(_e3106))));
let _e3112 = select(-1f, _e3080, (_e3080 > -1f));
let _e3114 = select(_e3075, _e3112, (_e3112 < _e3075));
let _e3121 = select(0i, select(select(i32(_e3114), i32(-2147483648), (_e3114 < -2147483600f)), 2147483647i, (_e3114 > 2147483500f)), (_e3114 == _e3114));
let _e3125 = (_e3121 - select(0i, 1i, (_e3114 < f32(_e3121))));
let _e3129 = global_1.member.member_8.member_7;
let _e3133 = global_1.member.member_8.member_8;
let _e3141 = (select(0i, select(select(i32(_e3065), i32(-2147483648), (_e3065 < -2147483600f)), 2147483647i, (_e3065 > 2147483500f)), (_e3065 == _e3065)) - 1i);
let _e3144 = (_e3110 + 1i);
let _e3154 = (select(0i, select(select(i32(_e3075), i32(-2147483648), (_e3075 < -2147483600f)), 2147483647i, (_e3075 > 2147483500f)), (_e3075 == _e3075)) - 1i);
let _e3157 = (_e3125 + 1i);
let _e3167 = (select(0i, select(select(i32(_e3055), i32(-2147483648), (_e3055 < -2147483600f)), 2147483647i, (_e3055 > 2147483500f)), (_e3055 == _e3055)) - 1i);
let _e3168 = (_e3095 - 1i);
let _e3173 = (_e3095 + 1i);
let _e3176 = (_e3095 + 2i);
let _e3179 = (select(0i, _e3110, (_e3110 > 0i)) * _e3129);
let _e3180 = (select(_e3141, _e3144, (_e3144 < _e3141)) * _e3129);
let _e3181 = (select(0i, _e3125, (_e3125 > 0i)) * _e3133);
let _e3182 = (select(_e3154, _e3157, (_e3157 < _e3154)) * _e3133);
local_8 = type_29(array<i32, 4>(select(0i, _e3168, (_e3168 > 0i)), select(0i, _e3095, (_e3095 > 0i)), select(_e3167, _e3173, (_e3173 < _e3167)), select(_e3167, _e3176, (_e3176 < _e3167))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = vec3<f32>((_e3060 - f32(_e3095)), (_e3070 - f32(_e3110)), (_e3080 - f32(_e3125)));
let _e3193 = (_e3181 + _e3179);
let _e3196 = local_8.member[1u];
let _e3197 = (_e3193 + _e3196);
let _e3199 = (bitcast<i32>(_e158) - 1i);
let _e3201 = select(_e3199, _e3197, (_e3197 < _e3199));
let _e3206 = global_2.member[bitcast<u32>(select(0i, _e3201, (_e3201 > 0i)))];
let _e3207 = bitcast<f32>(_e3206);
let _e3210 = local_8.member[2u];
let _e3211 = (_e3193 + _e3210);
let _e3213 = select(_e3199, _e3211, (_e3211 < _e3199));
let _e3218 = global_2.member[bitcast<u32>(select(0i, _e3213, (_e3213 > 0i)))];
let _e3220 = local_9[0u];
let _e3223 = (_e3207 + ((bitcast<f32>(_e3218) - _e3207) * _e3220));
let _e3224 = (_e3181 + _e3180);
let _e3225 = local_8.member[1u];
let _e3226 = (_e3224 + _e3225);
let _e3228 = select(_e3199, _e3226, (_e3226 < _e3199));
let _e3233 = global_2.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3234 = bitcast<f32>(_e3233);
let _e3235 = local_8.member[2u];
let _e3236 = (_e3224 + _e3235);
let _e3238 = select(_e3199, _e3236, (_e3236 < _e3199));
let _e3243 = global_2.member[bitcast<u32>(select(0i, _e3238, (_e3238 > 0i)))];
let _e3245 = local_9[0u];
let _e3250 = local_9[1u];
let _e3253 = (_e3223 + (((_e3234 + ((bitcast<f32>(_e3243) - _e3234) * _e3245)) - _e3223) * _e3250));
let _e3254 = (_e3182 + _e3179);
let _e3255 = local_8.member[1u];
let _e3256 = (_e3254 + _e3255);
let _e3258 = select(_e3199, _e3256, (_e3256 < _e3199));
let _e3263 = global_2.member[bitcast<u32>(select(0i, _e3258, (_e3258 > 0i)))];
let _e3264 = bitcast<f32>(_e3263);
let _e3265 = local_8.member[2u];
let _e3266 = (_e3254 + _e3265);
let _e3268 = select(_e3199, _e3266, (_e3266 < _e3199));
let _e3273 = global_2.member[bitcast<u32>(select(0i, _e3268, (_e3268 > 0i)))];
let _e3275 = local_9[0u];
let _e3278 = (_e3264 + ((bitcast<f32>(_e3273) - _e3264) * _e3275));
let _e3279 = (_e3182 + _e3180);
let _e3280 = local_8.member[1u];
let _e3281 = (_e3279 + _e3280);
let _e3283 = select(_e3199, _e3281, (_e3281 < _e3199));
let _e3288 = global_2.member[bitcast<u32>(select(0i, _e3283, (_e3283 > 0i)))];
let _e3289 = bitcast<f32>(_e3288);
let _e3290 = local_8.member[2u];
let _e3291 = (_e3279 + _e3290);
let _e3293 = select(_e3199, _e3291, (_e3291 < _e3199));
let _e3298 = global_2.member[bitcast<u32>(select(0i, _e3293, (_e3293 > 0i)))];
let _e3300 = local_9[0u];
let _e3304 = local_9[1u];
let _e3309 = local_9[2u];
let _e3316 = global_1.member.member_8.member_6;
let _e3320 = global_1.member.member_8.member_5;
let _e3322 = (((_e3253 + (((_e3278 + (((_e3289 + ((bitcast<f32>(_e3298) - _e3289) * _e3300)) - _e3278) * _e3304)) - _e3253) * _e3309)) - _e3316) * _e3320);
let _e3323 = -(1e9f);
let _e3325 = select(_e3323, _e3322, (_e3322 > _e3323));
let _e3327 = select(1e9f, _e3325, (_e3325 < 1e9f));
let _e3330 = global_1.member.member_1;
let _e3332 = ((_e3330 & 16u) == 0u);
if _e3332 {
phi_8532_ = type_7(1f, 1f, 1f);
} else {
let _e3336 = global_1.member.member_16.member;
let _e3347 = ((((_e3336.member.member * _e1127) + (_e3336.member.member_1 * _e1140)) + (_e3336.member.member_2 * _e1105)) + _e3336.member_1);
let _e3353 = ((((_e3336.member.member * _e1150) + (_e3336.member.member_1 * _e1155)) + (_e3336.member.member_2 * _e1144)) + _e3336.member_1);
let _e3355 = select(_e3353, _e3347, (_e3347 < _e3353));
let _e3357 = select(_e3353, _e3347, (_e3347 > _e3353));
let _e3359 = (_e3357 - _e3355);
let _e3362 = (-(_e3355) / select(1e-30f, _e3359, (_e3359 > 1e-30f)));
let _e3364 = select(0f, _e3362, (_e3362 > 0f));
let _e3370 = select(select(select(1f, _e3364, (_e3364 < 1f)), 1f, (_e3357 <= 0f)), 0f, (_e3355 > 0f));
let _e3375 = global_1.member.member_16.member_1;
let _e3376 = (_e3375 != 0u);
let _e3386 = global_1.member.member_17.member;
let _e3397 = ((((_e3386.member.member * _e1127) + (_e3386.member.member_1 * _e1140)) + (_e3386.member.member_2 * _e1105)) + _e3386.member_1);
let _e3403 = ((((_e3386.member.member * _e1150) + (_e3386.member.member_1 * _e1155)) + (_e3386.member.member_2 * _e1144)) + _e3386.member_1);
let _e3405 = select(_e3403, _e3397, (_e3397 < _e3403));
let _e3407 = select(_e3403, _e3397, (_e3397 > _e3403));
let _e3409 = (_e3407 - _e3405);
let _e3412 = (-(_e3405) / select(1e-30f, _e3409, (_e3409 > 1e-30f)));
let _e3414 = select(0f, _e3412, (_e3412 > 0f));
let _e3420 = select(select(select(1f, _e3414, (_e3414 < 1f)), 1f, (_e3407 <= 0f)), 0f, (_e3405 > 0f));
let _e3425 = global_1.member.member_17.member_1;
let _e3426 = (_e3425 != 0u);
let _e3436 = global_1.member.member_18.member;
let _e3447 = ((((_e3436.member.member * _e1127) + (_e3436.member.member_1 * _e1140)) + (_e3436.member.member_2 * _e1105)) + _e3436.member_1);
let _e3453 = ((((_e3436.member.member * _e1150) + (_e3436.member.member_1 * _e1155)) + (_e3436.member.member_2 * _e1144)) + _e3436.member_1);
let _e3455 = select(_e3453, _e3447, (_e3447 < _e3453));
let _e3457 = select(_e3453, _e3447, (_e3447 > _e3453));
let _e3459 = (_e3457 - _e3455);
let _e3462 = (-(_e3455) / select(1e-30f, _e3459, (_e3459 > 1e-30f)));
let _e3464 = select(0f, _e3462, (_e3462 > 0f));
let _e3470 = select(select(select(1f, _e3464, (_e3464 < 1f)), 1f, (_e3457 <= 0f)), 0f, (_e3455 > 0f));
let _e3475 = global_1.member.member_18.member_1;
let _e3476 = (_e3475 != 0u);
let _e3486 = global_1.member.member_19.member;
let _e3497 = ((((_e3486.member.member * _e1127) + (_e3486.member.member_1 * _e1140)) + (_e3486.member.member_2 * _e1105)) + _e3486.member_1);
let _e3503 = ((((_e3486.member.member * _e1150) + (_e3486.member.member_1 * _e1155)) + (_e3486.member.member_2 * _e1144)) + _e3486.member_1);
let _e3505 = select(_e3503, _e3497, (_e3497 < _e3503));
let _e3507 = select(_e3503, _e3497, (_e3497 > _e3503));
let _e3509 = (_e3507 - _e3505);
let _e3512 = (-(_e3505) / select(1e-30f, _e3509, (_e3509 > 1e-30f)));
let _e3514 = select(0f, _e3512, (_e3512 > 0f));
let _e3520 = select(select(select(1f, _e3514, (_e3514 < 1f)), 1f, (_e3507 <= 0f)), 0f, (_e3505 > 0f));
let _e3525 = global_1.member.member_19.member_1;
let _e3526 = (_e3525 != 0u);
phi_8532_ = type_7(((((1f * _e3370) * _e3420) * _e3470) * _e3520), ((((1f * select(1f, _e3370, _e3376)) * select(1f, _e3420, _e3426)) * select(1f, _e3470, _e3476)) * select(1f, _e3520, _e3526)), ((((1f * select(1f, 0f, (_e3376 && (_e3353 > 0f)))) * select(1f, 0f, (_e3426 && (_e3403 > 0f)))) * select(1f, 0f, (_e3476 && (_e3453 > 0f)))) * select(1f, 0f, (_e3526 && (_e3503 > 0f)))));
}
let _e3535 = phi_8532_;
let _e3536 = (_e1206 - _e1170);
let _e3540 = (bitcast<f32>((bitcast<u32>(_e3536) & 2147483647u)) < 1e-12f);
let _e3542 = (1f / select(_e3536, 1f, _e3540));
let _e3543 = (-0.5f - _e1170);
let _e3544 = (_e3543 * _e3542);
let _e3546 = ((_e3056 - _e1170) * _e3542);
let _e3552 = select(_e3546, _e3544, (_e3544 < _e3546));
let _e3554 = select(0f, _e3552, (_e3552 > 0f));
let _e3557 = select(select(1f, _e3554, (_e3554 < 1f)), select(2f, 0f, ((_e1170 >= -0.5f) && (_e1170 <= _e3056))), _e3540);
let _e3559 = select(_e3546, _e3544, (_e3544 > _e3546));
let _e3561 = select(0f, _e3559, (_e3559 > 0f));
let _e3564 = select(select(1f, _e3561, (_e3561 < 1f)), 1f, _e3540);
let _e3565 = (_e1212 - _e1185);
let _e3569 = (bitcast<f32>((bitcast<u32>(_e3565) & 2147483647u)) < 1e-12f);
let _e3571 = (1f / select(_e3565, 1f, _e3569));
let _e3572 = (-0.5f - _e1185);
let _e3573 = (_e3572 * _e3571);
let _e3575 = ((_e3066 - _e1185) * _e3571);
let _e3581 = select(_e3575, _e3573, (_e3573 < _e3575));
let _e3583 = select(0f, _e3581, (_e3581 > 0f));
let _e3586 = select(select(1f, _e3583, (_e3583 < 1f)), select(2f, 0f, ((_e1185 >= -0.5f) && (_e1185 <= _e3066))), _e3569);
let _e3588 = select(_e3575, _e3573, (_e3573 > _e3575));
let _e3590 = select(0f, _e3588, (_e3588 > 0f));
let _e3593 = select(select(1f, _e3590, (_e3590 < 1f)), 1f, _e3569);
let _e3594 = (_e1218 - _e1200);
let _e3598 = (bitcast<f32>((bitcast<u32>(_e3594) & 2147483647u)) < 1e-12f);
let _e3600 = (1f / select(_e3594, 1f, _e3598));
let _e3601 = (-0.5f - _e1200);
let _e3602 = (_e3601 * _e3600);
let _e3604 = ((_e3076 - _e1200) * _e3600);
let _e3610 = select(_e3604, _e3602, (_e3602 < _e3604));
let _e3612 = select(0f, _e3610, (_e3610 > 0f));
let _e3615 = select(select(1f, _e3612, (_e3612 < 1f)), select(2f, 0f, ((_e1200 >= -0.5f) && (_e1200 <= _e3076))), _e3598);
let _e3617 = select(_e3604, _e3602, (_e3602 > _e3604));
let _e3619 = select(0f, _e3617, (_e3617 > 0f));
let _e3622 = select(select(1f, _e3619, (_e3619 < 1f)), 1f, _e3598);
let _e3624 = select(_e3593, _e3564, (_e3564 < _e3593));
let _e3628 = select(_e3586, _e3557, (_e3557 > _e3586));
let _e3631 = (select(_e3622, _e3624, (_e3624 < _e3622)) - select(_e3615, _e3628, (_e3628 > _e3615)));
let _e3634 = (_e1150 - _e1127);
let _e3635 = (_e1155 - _e1140);
let _e3636 = (_e1144 - _e1105);
let _e3641 = (((_e3634 * _e3634) + (_e3635 * _e3635)) + (_e3636 * _e3636));
let _e3649 = global_1.member.member_7.member_3;
let _e3650 = ((sqrt(select(0f, _e3641, (_e3641 > 0f))) * select(0f, _e3631, (_e3631 > 0f))) * _e3649);
if (((_e173.member_2 == 3u) || (_e173.member_2 == 4u)) || _e1220) {
local_7 = _e3327;
let _e3656 = local_7;
let _e3658 = (bitcast<i32>(_e163) - 1i);
let _e3660 = select(_e3658, 263171i, (263171i < _e3658));
let _e3665 = global_3.member[bitcast<u32>(select(0i, _e3660, (_e3660 > 0i)))];
let _e3666 = bitcast<f32>(_e3665);
let _e3668 = select(_e3658, 263172i, (263172i < _e3658));
let _e3673 = global_3.member[bitcast<u32>(select(0i, _e3668, (_e3668 > 0i)))];
let _e3674 = bitcast<f32>(_e3673);
let _e3676 = select(_e3658, 263173i, (263173i < _e3658));
let _e3681 = global_3.member[bitcast<u32>(select(0i, _e3676, (_e3676 > 0i)))];
let _e3682 = bitcast<f32>(_e3681);
let _e3684 = ((_e3656 - _e3666) * _e3674);
let _e3686 = select(0f, _e3684, (_e3684 > 0f));
let _e3689 = local_7;
let _e3691 = select(_e3658, 263174i, (263174i < _e3658));
let _e3696 = global_3.member[bitcast<u32>(select(0i, _e3691, (_e3691 > 0i)))];
let _e3697 = bitcast<f32>(_e3696);
let _e3699 = select(_e3658, 263175i, (263175i < _e3658));
let _e3704 = global_3.member[bitcast<u32>(select(0i, _e3699, (_e3699 > 0i)))];
let _e3705 = bitcast<f32>(_e3704);
let _e3707 = select(_e3658, 263176i, (263176i < _e3658));
let _e3712 = global_3.member[bitcast<u32>(select(0i, _e3707, (_e3707 > 0i)))];
let _e3713 = bitcast<f32>(_e3712);
let _e3715 = ((_e3689 - _e3697) * _e3705);
let _e3717 = select(0f, _e3715, (_e3715 > 0f));
let _e3721 = local_7;
let _e3723 = select(_e3658, 263177i, (263177i < _e3658));
let _e3728 = global_3.member[bitcast<u32>(select(0i, _e3723, (_e3723 > 0i)))];
let _e3729 = bitcast<f32>(_e3728);
let _e3731 = select(_e3658, 263178i, (263178i < _e3658));
let _e3736 = global_3.member[bitcast<u32>(select(0i, _e3731, (_e3731 > 0i)))];
let _e3737 = bitcast<f32>(_e3736);
let _e3739 = select(_e3658, 263179i, (263179i < _e3658));
let _e3744 = global_3.member[bitcast<u32>(select(0i, _e3739, (_e3739 > 0i)))];
let _e3745 = bitcast<f32>(_e3744);
let _e3747 = ((_e3721 - _e3729) * _e3737);
let _e3749 = select(0f, _e3747, (_e3747 > 0f));
let _e3752 = local_7;
let _e3754 = select(_e3658, 263180i, (263180i < _e3658));
let _e3759 = global_3.member[bitcast<u32>(select(0i, _e3754, (_e3754 > 0i)))];
let _e3760 = bitcast<f32>(_e3759);
let _e3762 = select(_e3658, 263181i, (263181i < _e3658));
let _e3767 = global_3.member[bitcast<u32>(select(0i, _e3762, (_e3762 > 0i)))];
let _e3768 = bitcast<f32>(_e3767);
let _e3770 = select(_e3658, 263182i, (263182i < _e3658));
let _e3775 = global_3.member[bitcast<u32>(select(0i, _e3770, (_e3770 > 0i)))];
let _e3776 = bitcast<f32>(_e3775);
let _e3778 = ((_e3752 - _e3760) * _e3768);
let _e3780 = select(0f, _e3778, (_e3778 > 0f));
let _e3785 = local_7;
let _e3787 = select(_e3658, 263183i, (263183i < _e3658));
let _e3792 = global_3.member[bitcast<u32>(select(0i, _e3787, (_e3787 > 0i)))];
let _e3793 = bitcast<f32>(_e3792);
let _e3795 = select(_e3658, 263184i, (263184i < _e3658));
let _e3800 = global_3.member[bitcast<u32>(select(0i, _e3795, (_e3795 > 0i)))];
let _e3801 = bitcast<f32>(_e3800);
let _e3803 = select(_e3658, 263185i, (263185i < _e3658));
let _e3808 = global_3.member[bitcast<u32>(select(0i, _e3803, (_e3803 > 0i)))];
let _e3809 = bitcast<f32>(_e3808);
let _e3811 = ((_e3785 - _e3793) * _e3801);
let _e3813 = select(0f, _e3811, (_e3811 > 0f));
let _e3816 = local_7;
let _e3818 = select(_e3658, 263186i, (263186i < _e3658));
let _e3823 = global_3.member[bitcast<u32>(select(0i, _e3818, (_e3818 > 0i)))];
let _e3824 = bitcast<f32>(_e3823);
let _e3826 = select(_e3658, 263187i, (263187i < _e3658));
let _e3831 = global_3.member[bitcast<u32>(select(0i, _e3826, (_e3826 > 0i)))];
let _e3832 = bitcast<f32>(_e3831);
let _e3834 = select(_e3658, 263188i, (263188i < _e3658));
let _e3839 = global_3.member[bitcast<u32>(select(0i, _e3834, (_e3834 > 0i)))];
let _e3840 = bitcast<f32>(_e3839);
let _e3842 = ((_e3816 - _e3824) * _e3832);
let _e3844 = select(0f, _e3842, (_e3842 > 0f));
let _e3848 = local_7;
let _e3850 = select(_e3658, 263189i, (263189i < _e3658));
let _e3855 = global_3.member[bitcast<u32>(select(0i, _e3850, (_e3850 > 0i)))];
let _e3856 = bitcast<f32>(_e3855);
let _e3858 = select(_e3658, 263190i, (263190i < _e3658));
let _e3863 = global_3.member[bitcast<u32>(select(0i, _e3858, (_e3858 > 0i)))];
let _e3864 = bitcast<f32>(_e3863);
let _e3866 = select(_e3658, 263191i, (263191i < _e3658));
let _e3871 = global_3.member[bitcast<u32>(select(0i, _e3866, (_e3866 > 0i)))];
let _e3872 = bitcast<f32>(_e3871);
let _e3874 = ((_e3848 - _e3856) * _e3864);
let _e3876 = select(0f, _e3874, (_e3874 > 0f));
let _e3879 = local_7;
let _e3881 = select(_e3658, 263192i, (263192i < _e3658));
let _e3886 = global_3.member[bitcast<u32>(select(0i, _e3881, (_e3881 > 0i)))];
let _e3887 = bitcast<f32>(_e3886);
let _e3889 = select(_e3658, 263193i, (263193i < _e3658));
let _e3894 = global_3.member[bitcast<u32>(select(0i, _e3889, (_e3889 > 0i)))];
let _e3895 = bitcast<f32>(_e3894);
let _e3897 = select(_e3658, 263194i, (263194i < _e3658));
let _e3902 = global_3.member[bitcast<u32>(select(0i, _e3897, (_e3897 > 0i)))];
let _e3903 = bitcast<f32>(_e3902);
let _e3905 = ((_e3879 - _e3887) * _e3895);
let _e3907 = select(0f, _e3905, (_e3905 > 0f));
let _e3912 = (((select(_e3682, _e3686, (_e3686 < _e3682)) + select(_e3713, _e3717, (_e3717 < _e3713))) + (select(_e3745, _e3749, (_e3749 < _e3745)) + select(_e3776, _e3780, (_e3780 < _e3776)))) + ((select(_e3809, _e3813, (_e3813 < _e3809)) + select(_e3840, _e3844, (_e3844 < _e3840))) + (select(_e3872, _e3876, (_e3876 < _e3872)) + select(_e3903, _e3907, (_e3907 < _e3903)))));
local_6 = _e3050.member;
let _e3913 = local_6;
let _e3915 = ((_e3913 - _e3666) * _e3674);
let _e3917 = select(0f, _e3915, (_e3915 > 0f));
let _e3920 = local_6;
let _e3922 = ((_e3920 - _e3697) * _e3705);
let _e3924 = select(0f, _e3922, (_e3922 > 0f));
let _e3928 = local_6;
let _e3930 = ((_e3928 - _e3729) * _e3737);
let _e3932 = select(0f, _e3930, (_e3930 > 0f));
let _e3935 = local_6;
let _e3937 = ((_e3935 - _e3760) * _e3768);
let _e3939 = select(0f, _e3937, (_e3937 > 0f));
let _e3944 = local_6;
let _e3946 = ((_e3944 - _e3793) * _e3801);
let _e3948 = select(0f, _e3946, (_e3946 > 0f));
let _e3951 = local_6;
let _e3953 = ((_e3951 - _e3824) * _e3832);
let _e3955 = select(0f, _e3953, (_e3953 > 0f));
let _e3959 = local_6;
let _e3961 = ((_e3959 - _e3856) * _e3864);
let _e3963 = select(0f, _e3961, (_e3961 > 0f));
let _e3966 = local_6;
let _e3968 = ((_e3966 - _e3887) * _e3895);
let _e3970 = select(0f, _e3968, (_e3968 > 0f));
let _e3975 = (((select(_e3682, _e3917, (_e3917 < _e3682)) + select(_e3713, _e3924, (_e3924 < _e3713))) + (select(_e3745, _e3932, (_e3932 < _e3745)) + select(_e3776, _e3939, (_e3939 < _e3776)))) + ((select(_e3809, _e3948, (_e3948 < _e3809)) + select(_e3840, _e3955, (_e3955 < _e3840))) + (select(_e3872, _e3963, (_e3963 < _e3872)) + select(_e3903, _e3970, (_e3970 < _e3903)))));
let _e3976 = (255f - 1f);
let _e3978 = select(0f, _e3912, (_e3912 > 0f));
let _e3980 = select(_e3976, _e3978, (_e3978 < _e3976));
let _e3987 = select(0i, select(select(i32(_e3980), i32(-2147483648), (_e3980 < -2147483600f)), 2147483647i, (_e3980 > 2147483500f)), (_e3980 == _e3980));
let _e3991 = (_e3987 - select(0i, 1i, (_e3980 < f32(_e3987))));
let _e3993 = select(0f, _e3975, (_e3975 > 0f));
let _e3995 = select(_e3976, _e3993, (_e3993 < _e3976));
let _e4002 = select(0i, select(select(i32(_e3995), i32(-2147483648), (_e3995 < -2147483600f)), 2147483647i, (_e3995 > 2147483500f)), (_e3995 == _e3995));
let _e4006 = (_e4002 - select(0i, 1i, (_e3995 < f32(_e4002))));
let _e4008 = select(_e3658, 263195i, (263195i < _e3658));
let _e4014 = global_3.member[bitcast<u32>(select(0i, _e4008, (_e4008 > 0i)))];
let _e4015 = bitcast<f32>(_e4014);
let _e4017 = select(_e3658, 263196i, (263196i < _e3658));
let _e4023 = global_3.member[bitcast<u32>(select(0i, _e4017, (_e4017 > 0i)))];
let _e4024 = bitcast<f32>(_e4023);
let _e4025 = (_e3050.member - _e3327);
let _e4031 = (1f / select(_e4025, 1f, (bitcast<f32>((bitcast<u32>(_e4025) & 2147483647u)) < 1e-20f)));
let _e4037 = ((select(_e4015, _e3050.member, (_e3050.member < _e4015)) - select(_e4015, _e3327, (_e3327 < _e4015))) * _e4031);
let _e4043 = ((select(_e4024, _e3050.member, (_e3050.member > _e4024)) - select(_e4024, _e3327, (_e3327 > _e4024))) * _e4031);
let _e4046 = (((_e3991 * 256i) + _e4006) * 4i);
let _e4050 = (_e3975 - f32(_e4006));
let _e4054 = select(_e3658, _e4046, (_e4046 < _e3658));
let _e4060 = global_3.member[bitcast<u32>(select(0i, _e4054, (_e4054 > 0i)))];
let _e4061 = (_e4046 + 4i);
let _e4063 = select(_e3658, _e4061, (_e4061 < _e3658));
let _e4069 = global_3.member[bitcast<u32>(select(0i, _e4063, (_e4063 > 0i)))];
let _e4070 = (_e4046 + 1024i);
let _e4072 = select(_e3658, _e4070, (_e4070 < _e3658));
let _e4078 = global_3.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4079 = (_e4046 + 1028i);
let _e4081 = select(_e3658, _e4079, (_e4079 < _e3658));
let _e4087 = global_3.member[bitcast<u32>(select(0i, _e4081, (_e4081 > 0i)))];
let _e4089 = select(_e3658, 0i, (0i < _e3658));
let _e4095 = global_3.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4097 = select(_e3658, 262140i, (262140i < _e3658));
let _e4103 = global_3.member[bitcast<u32>(select(0i, _e4097, (_e4097 > 0i)))];
let _e4108 = (bitcast<f32>(((_e4060 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4116 = (_e4108 + (((bitcast<f32>(((_e4069 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4108) * _e4050));
let _e4121 = (bitcast<f32>(((_e4078 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4147 = (((_e4116 + (((_e4121 + (((bitcast<f32>(((_e4087 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4121) * _e4050)) - _e4116) * (_e3912 - f32(_e3991)))) * (1f - (_e4037 + _e4043))) + (((bitcast<f32>(((_e4095 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4037) + ((bitcast<f32>(((_e4103 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4043)));
let _e4151 = -((_e4147 * (_e3650 * _e3535.member)));
let _e4153 = select(-87f, _e4151, (_e4151 > -87f));
let _e4155 = select(88f, _e4153, (_e4153 < 88f));
let _e4157 = ((_e4155 * 1.442695f) + 0.5f);
let _e4159 = select(-127f, _e4157, (_e4157 > -127f));
let _e4161 = select(128f, _e4159, (_e4159 < 128f));
let _e4168 = select(0i, select(select(i32(_e4161), i32(-2147483648), (_e4161 < -2147483600f)), 2147483647i, (_e4161 > 2147483500f)), (_e4161 == _e4161));
let _e4172 = (_e4168 - select(0i, 1i, (_e4161 < f32(_e4168))));
let _e4173 = f32(_e4172);
let _e4177 = ((_e4155 - (_e4173 * 0.6933594f)) - (_e4173 * -2.1219444e-4f));
let _e4197 = ((1f + (_e4177 * (1f + (_e4177 * (0.5f + (_e4177 * (0.16666667f + (_e4177 * (0.041666668f + (_e4177 * (0.008333334f + (_e4177 * (0.001388889f + (_e4177 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4172 + 127i)) << bitcast<u32>(23i))));
let _e4198 = (1f - _e4197);
phi_12260_ = type_35(_e4197, _e4198, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4198 / select(1e-12f, _e4147, (_e4147 > 1e-12f))))));
} else {
local_5 = _e3327;
let _e4206 = local_5;
let _e4208 = (bitcast<i32>(_e163) - 1i);
let _e4210 = select(_e4208, 263171i, (263171i < _e4208));
let _e4215 = global_3.member[bitcast<u32>(select(0i, _e4210, (_e4210 > 0i)))];
let _e4216 = bitcast<f32>(_e4215);
let _e4218 = select(_e4208, 263172i, (263172i < _e4208));
let _e4223 = global_3.member[bitcast<u32>(select(0i, _e4218, (_e4218 > 0i)))];
let _e4224 = bitcast<f32>(_e4223);
let _e4226 = select(_e4208, 263173i, (263173i < _e4208));
let _e4231 = global_3.member[bitcast<u32>(select(0i, _e4226, (_e4226 > 0i)))];
let _e4232 = bitcast<f32>(_e4231);
let _e4234 = ((_e4206 - _e4216) * _e4224);
let _e4236 = select(0f, _e4234, (_e4234 > 0f));
let _e4239 = local_5;
let _e4241 = select(_e4208, 263174i, (263174i < _e4208));
let _e4246 = global_3.member[bitcast<u32>(select(0i, _e4241, (_e4241 > 0i)))];
let _e4247 = bitcast<f32>(_e4246);
let _e4249 = select(_e4208, 263175i, (263175i < _e4208));
let _e4254 = global_3.member[bitcast<u32>(select(0i, _e4249, (_e4249 > 0i)))];
let _e4255 = bitcast<f32>(_e4254);
let _e4257 = select(_e4208, 263176i, (263176i < _e4208));
let _e4262 = global_3.member[bitcast<u32>(select(0i, _e4257, (_e4257 > 0i)))];
let _e4263 = bitcast<f32>(_e4262);
let _e4265 = ((_e4239 - _e4247) * _e4255);
let _e4267 = select(0f, _e4265, (_e4265 > 0f));
let _e4271 = local_5;
let _e4273 = select(_e4208, 263177i, (263177i < _e4208));
let _e4278 = global_3.member[bitcast<u32>(select(0i, _e4273, (_e4273 > 0i)))];
let _e4279 = bitcast<f32>(_e4278);
let _e4281 = select(_e4208, 263178i, (263178i < _e4208));
let _e4286 = global_3.member[bitcast<u32>(select(0i, _e4281, (_e4281 > 0i)))];
let _e4287 = bitcast<f32>(_e4286);
let _e4289 = select(_e4208, 263179i, (263179i < _e4208));
let _e4294 = global_3.member[bitcast<u32>(select(0i, _e4289, (_e4289 > 0i)))];
let _e4295 = bitcast<f32>(_e4294);
let _e4297 = ((_e4271 - _e4279) * _e4287);
let _e4299 = select(0f, _e4297, (_e4297 > 0f));
let _e4302 = local_5;
let _e4304 = select(_e4208, 263180i, (263180i < _e4208));
let _e4309 = global_3.member[bitcast<u32>(select(0i, _e4304, (_e4304 > 0i)))];
let _e4310 = bitcast<f32>(_e4309);
let _e4312 = select(_e4208, 263181i, (263181i < _e4208));
let _e4317 = global_3.member[bitcast<u32>(select(0i, _e4312, (_e4312 > 0i)))];
let _e4318 = bitcast<f32>(_e4317);
let _e4320 = select(_e4208, 263182i, (263182i < _e4208));
let _e4325 = global_3.member[bitcast<u32>(select(0i, _e4320, (_e4320 > 0i)))];
let _e4326 = bitcast<f32>(_e4325);
let _e4328 = ((_e4302 - _e4310) * _e4318);
let _e4330 = select(0f, _e4328, (_e4328 > 0f));
let _e4335 = local_5;
let _e4337 = select(_e4208, 263183i, (263183i < _e4208));
let _e4342 = global_3.member[bitcast<u32>(select(0i, _e4337, (_e4337 > 0i)))];
let _e4343 = bitcast<f32>(_e4342);
let _e4345 = select(_e4208, 263184i, (263184i < _e4208));
let _e4350 = global_3.member[bitcast<u32>(select(0i, _e4345, (_e4345 > 0i)))];
let _e4351 = bitcast<f32>(_e4350);
let _e4353 = select(_e4208, 263185i, (263185i < _e4208));
let _e4358 = global_3.member[bitcast<u32>(select(0i, _e4353, (_e4353 > 0i)))];
let _e4359 = bitcast<f32>(_e4358);
let _e4361 = ((_e4335 - _e4343) * _e4351);
let _e4363 = select(0f, _e4361, (_e4361 > 0f));
let _e4366 = local_5;
let _e4368 = select(_e4208, 263186i, (263186i < _e4208));
let _e4373 = global_3.member[bitcast<u32>(select(0i, _e4368, (_e4368 > 0i)))];
let _e4374 = bitcast<f32>(_e4373);
let _e4376 = select(_e4208, 263187i, (263187i < _e4208));
let _e4381 = global_3.member[bitcast<u32>(select(0i, _e4376, (_e4376 > 0i)))];
let _e4382 = bitcast<f32>(_e4381);
let _e4384 = select(_e4208, 263188i, (263188i < _e4208));
let _e4389 = global_3.member[bitcast<u32>(select(0i, _e4384, (_e4384 > 0i)))];
let _e4390 = bitcast<f32>(_e4389);
let _e4392 = ((_e4366 - _e4374) * _e4382);
let _e4394 = select(0f, _e4392, (_e4392 > 0f));
let _e4398 = local_5;
let _e4400 = select(_e4208, 263189i, (263189i < _e4208));
let _e4405 = global_3.member[bitcast<u32>(select(0i, _e4400, (_e4400 > 0i)))];
let _e4406 = bitcast<f32>(_e4405);
let _e4408 = select(_e4208, 263190i, (263190i < _e4208));
let _e4413 = global_3.member[bitcast<u32>(select(0i, _e4408, (_e4408 > 0i)))];
let _e4414 = bitcast<f32>(_e4413);
let _e4416 = select(_e4208, 263191i, (263191i < _e4208));
let _e4421 = global_3.member[bitcast<u32>(select(0i, _e4416, (_e4416 > 0i)))];
let _e4422 = bitcast<f32>(_e4421);
let _e4424 = ((_e4398 - _e4406) * _e4414);
let _e4426 = select(0f, _e4424, (_e4424 > 0f));
let _e4429 = local_5;
let _e4431 = select(_e4208, 263192i, (263192i < _e4208));
let _e4436 = global_3.member[bitcast<u32>(select(0i, _e4431, (_e4431 > 0i)))];
let _e4437 = bitcast<f32>(_e4436);
let _e4439 = select(_e4208, 263193i, (263193i < _e4208));
let _e4444 = global_3.member[bitcast<u32>(select(0i, _e4439, (_e4439 > 0i)))];
let _e4445 = bitcast<f32>(_e4444);
let _e4447 = select(_e4208, 263194i, (263194i < _e4208));
let _e4452 = global_3.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4453 = bitcast<f32>(_e4452);
let _e4455 = ((_e4429 - _e4437) * _e4445);
let _e4457 = select(0f, _e4455, (_e4455 > 0f));
let _e4462 = (((select(_e4232, _e4236, (_e4236 < _e4232)) + select(_e4263, _e4267, (_e4267 < _e4263))) + (select(_e4295, _e4299, (_e4299 < _e4295)) + select(_e4326, _e4330, (_e4330 < _e4326)))) + ((select(_e4359, _e4363, (_e4363 < _e4359)) + select(_e4390, _e4394, (_e4394 < _e4390))) + (select(_e4422, _e4426, (_e4426 < _e4422)) + select(_e4453, _e4457, (_e4457 < _e4453)))));
local_4 = _e3050.member;
let _e4463 = local_4;
let _e4465 = ((_e4463 - _e4216) * _e4224);
let _e4467 = select(0f, _e4465, (_e4465 > 0f));
let _e4470 = local_4;
let _e4472 = ((_e4470 - _e4247) * _e4255);
let _e4474 = select(0f, _e4472, (_e4472 > 0f));
let _e4478 = local_4;
let _e4480 = ((_e4478 - _e4279) * _e4287);
let _e4482 = select(0f, _e4480, (_e4480 > 0f));
let _e4485 = local_4;
let _e4487 = ((_e4485 - _e4310) * _e4318);
let _e4489 = select(0f, _e4487, (_e4487 > 0f));
let _e4494 = local_4;
let _e4496 = ((_e4494 - _e4343) * _e4351);
let _e4498 = select(0f, _e4496, (_e4496 > 0f));
let _e4501 = local_4;
let _e4503 = ((_e4501 - _e4374) * _e4382);
let _e4505 = select(0f, _e4503, (_e4503 > 0f));
let _e4509 = local_4;
let _e4511 = ((_e4509 - _e4406) * _e4414);
let _e4513 = select(0f, _e4511, (_e4511 > 0f));
let _e4516 = local_4;
let _e4518 = ((_e4516 - _e4437) * _e4445);
let _e4520 = select(0f, _e4518, (_e4518 > 0f));
let _e4525 = (((select(_e4232, _e4467, (_e4467 < _e4232)) + select(_e4263, _e4474, (_e4474 < _e4263))) + (select(_e4295, _e4482, (_e4482 < _e4295)) + select(_e4326, _e4489, (_e4489 < _e4326)))) + ((select(_e4359, _e4498, (_e4498 < _e4359)) + select(_e4390, _e4505, (_e4505 < _e4390))) + (select(_e4422, _e4513, (_e4513 < _e4422)) + select(_e4453, _e4520, (_e4520 < _e4453)))));
let _e4526 = (255f - 1f);
let _e4528 = select(0f, _e4462, (_e4462 > 0f));
let _e4530 = select(_e4526, _e4528, (_e4528 < _e4526));
let _e4537 = select(0i, select(select(i32(_e4530), i32(-2147483648), (_e4530 < -2147483600f)), 2147483647i, (_e4530 > 2147483500f)), (_e4530 == _e4530));
let _e4541 = (_e4537 - select(0i, 1i, (_e4530 < f32(_e4537))));
let _e4543 = select(0f, _e4525, (_e4525 > 0f));
let _e4545 = select(_e4526, _e4543, (_e4543 < _e4526));
let _e4552 = select(0i, select(select(i32(_e4545), i32(-2147483648), (_e4545 < -2147483600f)), 2147483647i, (_e4545 > 2147483500f)), (_e4545 == _e4545));
let _e4556 = (_e4552 - select(0i, 1i, (_e4545 < f32(_e4552))));
let _e4558 = select(_e4208, 263195i, (263195i < _e4208));
let _e4564 = global_3.member[bitcast<u32>(select(0i, _e4558, (_e4558 > 0i)))];
let _e4565 = bitcast<f32>(_e4564);
let _e4567 = select(_e4208, 263196i, (263196i < _e4208));
let _e4573 = global_3.member[bitcast<u32>(select(0i, _e4567, (_e4567 > 0i)))];
let _e4574 = bitcast<f32>(_e4573);
let _e4575 = (_e3050.member - _e3327);
let _e4581 = (1f / select(_e4575, 1f, (bitcast<f32>((bitcast<u32>(_e4575) & 2147483647u)) < 1e-20f)));
let _e4587 = ((select(_e4565, _e3050.member, (_e3050.member < _e4565)) - select(_e4565, _e3327, (_e3327 < _e4565))) * _e4581);
let _e4593 = ((select(_e4574, _e3050.member, (_e3050.member > _e4574)) - select(_e4574, _e3327, (_e3327 > _e4574))) * _e4581);
let _e4596 = (((_e4541 * 256i) + _e4556) * 4i);
let _e4598 = (_e4462 - f32(_e4541));
let _e4600 = (_e4525 - f32(_e4556));
let _e4602 = (1f - (_e4587 + _e4593));
let _e4604 = select(_e4208, _e4596, (_e4596 < _e4208));
let _e4610 = global_3.member[bitcast<u32>(select(0i, _e4604, (_e4604 > 0i)))];
let _e4611 = (_e4596 + 4i);
let _e4613 = select(_e4208, _e4611, (_e4611 < _e4208));
let _e4619 = global_3.member[bitcast<u32>(select(0i, _e4613, (_e4613 > 0i)))];
let _e4620 = (_e4596 + 1024i);
let _e4622 = select(_e4208, _e4620, (_e4620 < _e4208));
let _e4628 = global_3.member[bitcast<u32>(select(0i, _e4622, (_e4622 > 0i)))];
let _e4629 = (_e4596 + 1028i);
let _e4631 = select(_e4208, _e4629, (_e4629 < _e4208));
let _e4637 = global_3.member[bitcast<u32>(select(0i, _e4631, (_e4631 > 0i)))];
let _e4639 = select(_e4208, 0i, (0i < _e4208));
let _e4645 = global_3.member[bitcast<u32>(select(0i, _e4639, (_e4639 > 0i)))];
let _e4647 = select(_e4208, 262140i, (262140i < _e4208));
let _e4653 = global_3.member[bitcast<u32>(select(0i, _e4647, (_e4647 > 0i)))];
let _e4658 = (bitcast<f32>(((_e4610 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4666 = (_e4658 + (((bitcast<f32>(((_e4619 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4658) * _e4600));
let _e4671 = (bitcast<f32>(((_e4628 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4697 = (((_e4666 + (((_e4671 + (((bitcast<f32>(((_e4637 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4671) * _e4600)) - _e4666) * _e4598)) * _e4602) + (((bitcast<f32>(((_e4645 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4587) + ((bitcast<f32>(((_e4653 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4593)));
let _e4714 = (bitcast<f32>((((_e4610 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4722 = (_e4714 + (((bitcast<f32>((((_e4619 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4714) * _e4600));
let _e4727 = (bitcast<f32>((((_e4628 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4754 = (_e4596 + 1i);
let _e4756 = select(_e4208, _e4754, (_e4754 < _e4208));
let _e4762 = global_3.member[bitcast<u32>(select(0i, _e4756, (_e4756 > 0i)))];
let _e4763 = (_e4596 + 5i);
let _e4765 = select(_e4208, _e4763, (_e4763 < _e4208));
let _e4771 = global_3.member[bitcast<u32>(select(0i, _e4765, (_e4765 > 0i)))];
let _e4772 = (_e4596 + 1025i);
let _e4774 = select(_e4208, _e4772, (_e4772 < _e4208));
let _e4780 = global_3.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4781 = (_e4596 + 1029i);
let _e4783 = select(_e4208, _e4781, (_e4781 < _e4208));
let _e4789 = global_3.member[bitcast<u32>(select(0i, _e4783, (_e4783 > 0i)))];
let _e4791 = select(_e4208, 1i, (1i < _e4208));
let _e4797 = global_3.member[bitcast<u32>(select(0i, _e4791, (_e4791 > 0i)))];
let _e4799 = select(_e4208, 262141i, (262141i < _e4208));
let _e4805 = global_3.member[bitcast<u32>(select(0i, _e4799, (_e4799 > 0i)))];
let _e4810 = (bitcast<f32>(((_e4762 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4818 = (_e4810 + (((bitcast<f32>(((_e4771 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4810) * _e4600));
let _e4823 = (bitcast<f32>(((_e4780 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4866 = (bitcast<f32>((((_e4762 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4874 = (_e4866 + (((bitcast<f32>((((_e4771 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4866) * _e4600));
let _e4879 = (bitcast<f32>((((_e4780 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4909 = (_e3650 * _e3535.member_1);
let _e4911 = -(((((_e4722 + (((_e4727 + (((bitcast<f32>((((_e4637 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4727) * _e4600)) - _e4722) * _e4598)) * _e4602) + (((bitcast<f32>((((_e4645 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4587) + ((bitcast<f32>((((_e4653 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4593))) * _e4909));
let _e4913 = select(-87f, _e4911, (_e4911 > -87f));
let _e4915 = select(88f, _e4913, (_e4913 < 88f));
let _e4917 = ((_e4915 * 1.442695f) + 0.5f);
let _e4919 = select(-127f, _e4917, (_e4917 > -127f));
let _e4921 = select(128f, _e4919, (_e4919 < 128f));
let _e4928 = select(0i, select(select(i32(_e4921), i32(-2147483648), (_e4921 < -2147483600f)), 2147483647i, (_e4921 > 2147483500f)), (_e4921 == _e4921));
let _e4932 = (_e4928 - select(0i, 1i, (_e4921 < f32(_e4928))));
let _e4933 = f32(_e4932);
let _e4937 = ((_e4915 - (_e4933 * 0.6933594f)) - (_e4933 * -2.1219444e-4f));
let _e4959 = -(((((_e4818 + (((_e4823 + (((bitcast<f32>(((_e4789 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4823) * _e4600)) - _e4818) * _e4598)) * _e4602) + (((bitcast<f32>(((_e4797 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4587) + ((bitcast<f32>(((_e4805 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4593))) * _e4909));
let _e4961 = select(-87f, _e4959, (_e4959 > -87f));
let _e4963 = select(88f, _e4961, (_e4961 < 88f));
let _e4965 = ((_e4963 * 1.442695f) + 0.5f);
let _e4967 = select(-127f, _e4965, (_e4965 > -127f));
let _e4969 = select(128f, _e4967, (_e4967 < 128f));
let _e4976 = select(0i, select(select(i32(_e4969), i32(-2147483648), (_e4969 < -2147483600f)), 2147483647i, (_e4969 > 2147483500f)), (_e4969 == _e4969));
let _e4980 = (_e4976 - select(0i, 1i, (_e4969 < f32(_e4976))));
let _e4981 = f32(_e4980);
let _e4985 = ((_e4963 - (_e4981 * 0.6933594f)) - (_e4981 * -2.1219444e-4f));
let _e5007 = -(((((_e4874 + (((_e4879 + (((bitcast<f32>((((_e4789 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4879) * _e4600)) - _e4874) * _e4598)) * _e4602) + (((bitcast<f32>((((_e4797 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4587) + ((bitcast<f32>((((_e4805 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4593))) * _e4909));
let _e5009 = select(-87f, _e5007, (_e5007 > -87f));
let _e5011 = select(88f, _e5009, (_e5009 < 88f));
let _e5013 = ((_e5011 * 1.442695f) + 0.5f);
let _e5015 = select(-127f, _e5013, (_e5013 > -127f));
let _e5017 = select(128f, _e5015, (_e5015 < 128f));
let _e5024 = select(0i, select(select(i32(_e5017), i32(-2147483648), (_e5017 < -2147483600f)), 2147483647i, (_e5017 > 2147483500f)), (_e5017 == _e5017));
let _e5028 = (_e5024 - select(0i, 1i, (_e5017 < f32(_e5024))));
let _e5029 = f32(_e5028);
let _e5033 = ((_e5011 - (_e5029 * 0.6933594f)) - (_e5029 * -2.1219444e-4f));
let _e5056 = -((_e4697 * (_e3650 * _e3535.member)));
let _e5058 = select(-87f, _e5056, (_e5056 > -87f));
let _e5060 = select(88f, _e5058, (_e5058 < 88f));
let _e5062 = ((_e5060 * 1.442695f) + 0.5f);
let _e5064 = select(-127f, _e5062, (_e5062 > -127f));
let _e5066 = select(128f, _e5064, (_e5064 < 128f));
let _e5073 = select(0i, select(select(i32(_e5066), i32(-2147483648), (_e5066 < -2147483600f)), 2147483647i, (_e5066 > 2147483500f)), (_e5066 == _e5066));
let _e5077 = (_e5073 - select(0i, 1i, (_e5066 < f32(_e5073))));
let _e5078 = f32(_e5077);
let _e5082 = ((_e5060 - (_e5078 * 0.6933594f)) - (_e5078 * -2.1219444e-4f));
let _e5102 = ((1f + (_e5082 * (1f + (_e5082 * (0.5f + (_e5082 * (0.16666667f + (_e5082 * (0.041666668f + (_e5082 * (0.008333334f + (_e5082 * (0.001388889f + (_e5082 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5077 + 127i)) << bitcast<u32>(23i))));
let _e5103 = (1f - _e5102);
phi_12260_ = type_35(_e5102, _e5103, vec3<f32>(((1f + (_e4937 * (1f + (_e4937 * (0.5f + (_e4937 * (0.16666667f + (_e4937 * (0.041666668f + (_e4937 * (0.008333334f + (_e4937 * (0.001388889f + (_e4937 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4932 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4985 * (1f + (_e4985 * (0.5f + (_e4985 * (0.16666667f + (_e4985 * (0.041666668f + (_e4985 * (0.008333334f + (_e4985 * (0.001388889f + (_e4985 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4980 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5033 * (1f + (_e5033 * (0.5f + (_e5033 * (0.16666667f + (_e5033 * (0.041666668f + (_e5033 * (0.008333334f + (_e5033 * (0.001388889f + (_e5033 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5028 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5103 / select(1e-12f, _e4697, (_e4697 > 1e-12f))))));
}
let _e5111 = phi_12260_;
if _e1227 {
let _e5116 = global_1.member.member_8.member.member;
let _e5124 = global_1.member.member_8.member_1.member;
let _e5132 = global_1.member.member_8.member_2.member;
let _e5136 = (-0.5f - _e1206);
let _e5137 = -(_e3543);
let _e5140 = (_e3543 - _e5136);
let _e5141 = (_e5136 - _e3543);
let _e5143 = select(_e5141, _e5140, (_e5140 > _e5141));
let _e5146 = (select(_e5137, _e3543, (_e3543 > _e5137)) / select(1e-30f, _e5143, (_e5143 > 1e-30f)));
let _e5148 = (_e5136 < 0f);
let _e5150 = select(0f, select(2f, _e5146, _e5148), (_e3543 > 0f));
let _e5151 = (_e5136 > 0f);
let _e5154 = select(2f, select(0f, _e5146, (_e3543 < 0f)), _e5151);
let _e5155 = (_e3543 > -1e30f);
let _e5159 = ((_e5150 > -1f) || ((_e5150 == -1f) && _e5155));
let _e5160 = (_e5154 < 2f);
let _e5161 = select(-1f, _e5150, _e5159);
let _e5165 = select(2f, _e5154, _e5160);
let _e5169 = select(-1e30f, _e3543, _e5155);
let _e5170 = (_e5136 > -1e30f);
let _e5171 = select(-1e30f, _e5136, _e5170);
let _e5175 = (_e1170 - _e3056);
let _e5176 = (_e1206 - _e3056);
let _e5177 = -(_e5175);
let _e5180 = (_e5175 - _e5176);
let _e5181 = (_e5176 - _e5175);
let _e5183 = select(_e5181, _e5180, (_e5180 > _e5181));
let _e5186 = (select(_e5177, _e5175, (_e5175 > _e5177)) / select(1e-30f, _e5183, (_e5183 > 1e-30f)));
let _e5188 = (_e5176 < 0f);
let _e5190 = select(0f, select(2f, _e5186, _e5188), (_e5175 > 0f));
let _e5191 = (_e5176 > 0f);
let _e5194 = select(2f, select(0f, _e5186, (_e5175 < 0f)), _e5191);
let _e5195 = (_e5175 > _e5169);
let _e5199 = ((_e5190 > _e5161) || ((_e5190 == _e5161) && _e5195));
let _e5200 = (_e5194 < _e5165);
let _e5201 = select(_e5161, _e5190, _e5199);
let _e5205 = select(_e5165, _e5194, _e5200);
let _e5209 = select(_e5169, _e5175, _e5195);
let _e5210 = (_e5176 > _e5171);
let _e5211 = select(_e5171, _e5176, _e5210);
let _e5215 = (-0.5f - _e1212);
let _e5216 = -(_e3572);
let _e5219 = (_e3572 - _e5215);
let _e5220 = (_e5215 - _e3572);
let _e5222 = select(_e5220, _e5219, (_e5219 > _e5220));
let _e5225 = (select(_e5216, _e3572, (_e3572 > _e5216)) / select(1e-30f, _e5222, (_e5222 > 1e-30f)));
let _e5227 = (_e5215 < 0f);
let _e5229 = select(0f, select(2f, _e5225, _e5227), (_e3572 > 0f));
let _e5230 = (_e5215 > 0f);
let _e5233 = select(2f, select(0f, _e5225, (_e3572 < 0f)), _e5230);
let _e5234 = (_e3572 > _e5209);
let _e5238 = ((_e5229 > _e5201) || ((_e5229 == _e5201) && _e5234));
let _e5239 = (_e5233 < _e5205);
let _e5240 = select(_e5201, _e5229, _e5238);
let _e5244 = select(_e5205, _e5233, _e5239);
let _e5248 = select(_e5209, _e3572, _e5234);
let _e5249 = (_e5215 > _e5211);
let _e5250 = select(_e5211, _e5215, _e5249);
let _e5254 = (_e1185 - _e3066);
let _e5255 = (_e1212 - _e3066);
let _e5256 = -(_e5254);
let _e5259 = (_e5254 - _e5255);
let _e5260 = (_e5255 - _e5254);
let _e5262 = select(_e5260, _e5259, (_e5259 > _e5260));
let _e5265 = (select(_e5256, _e5254, (_e5254 > _e5256)) / select(1e-30f, _e5262, (_e5262 > 1e-30f)));
let _e5267 = (_e5255 < 0f);
let _e5269 = select(0f, select(2f, _e5265, _e5267), (_e5254 > 0f));
let _e5270 = (_e5255 > 0f);
let _e5273 = select(2f, select(0f, _e5265, (_e5254 < 0f)), _e5270);
let _e5274 = (_e5254 > _e5248);
let _e5278 = ((_e5269 > _e5240) || ((_e5269 == _e5240) && _e5274));
let _e5279 = (_e5273 < _e5244);
let _e5280 = select(_e5240, _e5269, _e5278);
let _e5284 = select(_e5244, _e5273, _e5279);
let _e5288 = select(_e5248, _e5254, _e5274);
let _e5289 = (_e5255 > _e5250);
let _e5290 = select(_e5250, _e5255, _e5289);
let _e5294 = (-0.5f - _e1218);
let _e5295 = -(_e3601);
let _e5298 = (_e3601 - _e5294);
let _e5299 = (_e5294 - _e3601);
let _e5301 = select(_e5299, _e5298, (_e5298 > _e5299));
let _e5304 = (select(_e5295, _e3601, (_e3601 > _e5295)) / select(1e-30f, _e5301, (_e5301 > 1e-30f)));
let _e5306 = (_e5294 < 0f);
let _e5308 = select(0f, select(2f, _e5304, _e5306), (_e3601 > 0f));
let _e5309 = (_e5294 > 0f);
let _e5312 = select(2f, select(0f, _e5304, (_e3601 < 0f)), _e5309);
let _e5313 = (_e3601 > _e5288);
let _e5317 = ((_e5308 > _e5280) || ((_e5308 == _e5280) && _e5313));
let _e5318 = (_e5312 < _e5284);
let _e5319 = select(_e5280, _e5308, _e5317);
let _e5323 = select(_e5284, _e5312, _e5318);
let _e5327 = select(_e5288, _e3601, _e5313);
let _e5328 = (_e5294 > _e5290);
let _e5329 = select(_e5290, _e5294, _e5328);
let _e5333 = (_e1200 - _e3076);
let _e5334 = (_e1218 - _e3076);
let _e5335 = -(_e5333);
let _e5338 = (_e5333 - _e5334);
let _e5339 = (_e5334 - _e5333);
let _e5341 = select(_e5339, _e5338, (_e5338 > _e5339));
let _e5344 = (select(_e5335, _e5333, (_e5333 > _e5335)) / select(1e-30f, _e5341, (_e5341 > 1e-30f)));
let _e5346 = (_e5334 < 0f);
let _e5348 = select(0f, select(2f, _e5344, _e5346), (_e5333 > 0f));
let _e5349 = (_e5334 > 0f);
let _e5352 = select(2f, select(0f, _e5344, (_e5333 < 0f)), _e5349);
let _e5353 = (_e5333 > _e5327);
let _e5357 = ((_e5348 > _e5319) || ((_e5348 == _e5319) && _e5353));
let _e5358 = (_e5352 < _e5323);
let _e5359 = select(_e5319, _e5348, _e5357);
let _e5360 = select(select(select(select(select(select(0f, _e5116.member, _e5159), _e5116.member, _e5199), _e5124.member, _e5238), _e5124.member, _e5278), _e5132.member, _e5317), _e5132.member, _e5357);
let _e5361 = select(select(select(select(select(select(0f, _e5116.member_1, _e5159), _e5116.member_1, _e5199), _e5124.member_1, _e5238), _e5124.member_1, _e5278), _e5132.member_1, _e5317), _e5132.member_1, _e5357);
let _e5362 = select(select(select(select(select(select(1f, _e5116.member_2, _e5159), _e5116.member_2, _e5199), _e5124.member_2, _e5238), _e5124.member_2, _e5278), _e5132.member_2, _e5317), _e5132.member_2, _e5357);
let _e5364 = select(_e5323, _e5352, _e5358);
let _e5365 = select(select(select(select(select(select(0f, _e5116.member, _e5160), _e5116.member, _e5200), _e5124.member, _e5239), _e5124.member, _e5279), _e5132.member, _e5318), _e5132.member, _e5358);
let _e5366 = select(select(select(select(select(select(0f, _e5116.member_1, _e5160), _e5116.member_1, _e5200), _e5124.member_1, _e5239), _e5124.member_1, _e5279), _e5132.member_1, _e5318), _e5132.member_1, _e5358);
let _e5367 = select(select(select(select(select(select(1f, _e5116.member_2, _e5160), _e5116.member_2, _e5200), _e5124.member_2, _e5239), _e5124.member_2, _e5279), _e5132.member_2, _e5318), _e5132.member_2, _e5358);
let _e5369 = select(_e5327, _e5333, _e5353);
let _e5370 = (_e5334 > _e5329);
let _e5371 = select(_e5329, _e5334, _e5370);
let _e5372 = select(select(select(select(select(select(0f, _e5116.member, _e5155), _e5116.member, _e5195), _e5124.member, _e5234), _e5124.member, _e5274), _e5132.member, _e5313), _e5132.member, _e5353);
let _e5373 = select(select(select(select(select(select(0f, _e5116.member_1, _e5155), _e5116.member_1, _e5195), _e5124.member_1, _e5234), _e5124.member_1, _e5274), _e5132.member_1, _e5313), _e5132.member_1, _e5353);
let _e5374 = select(select(select(select(select(select(1f, _e5116.member_2, _e5155), _e5116.member_2, _e5195), _e5124.member_2, _e5234), _e5124.member_2, _e5274), _e5132.member_2, _e5313), _e5132.member_2, _e5353);
if _e3332 {
phi_13579_ = type_34(_e5359, vec3<f32>(_e5360, _e5361, _e5362), _e5364, vec3<f32>(_e5365, _e5366, _e5367), _e5369, _e5371, vec3<f32>(_e5372, _e5373, _e5374));
} else {
let _e5381 = (((_e5116.member * _e5116.member) + (_e5116.member_1 * _e5116.member_1)) + (_e5116.member_2 * _e5116.member_2));
let _e5384 = sqrt(select(0f, _e5381, (_e5381 > 0f)));
let _e5388 = global_1.member.member_16.member_1;
let _e5389 = (_e5388 != 0u);
let _e5393 = global_1.member.member_16.member;
let _e5413 = select(-1e6f, (((((_e5393.member.member * _e1127) + (_e5393.member.member_1 * _e1140)) + (_e5393.member.member_2 * _e1105)) + _e5393.member_1) * _e5384), _e5389);
let _e5414 = select(-1e6f, (((((_e5393.member.member * _e1150) + (_e5393.member.member_1 * _e1155)) + (_e5393.member.member_2 * _e1144)) + _e5393.member_1) * _e5384), _e5389);
let _e5419 = global_1.member.member_16.member.member;
let _e5423 = -(_e5413);
let _e5426 = (_e5413 - _e5414);
let _e5427 = (_e5414 - _e5413);
let _e5429 = select(_e5427, _e5426, (_e5426 > _e5427));
let _e5432 = (select(_e5423, _e5413, (_e5413 > _e5423)) / select(1e-30f, _e5429, (_e5429 > 1e-30f)));
let _e5436 = select(0f, select(2f, _e5432, (_e5414 < 0f)), (_e5413 > 0f));
let _e5440 = select(2f, select(0f, _e5432, (_e5413 < 0f)), (_e5414 > 0f));
let _e5441 = (_e5413 > _e5369);
let _e5445 = ((_e5436 > _e5359) || ((_e5436 == _e5359) && _e5441));
let _e5446 = (_e5440 < _e5364);
let _e5447 = select(_e5359, _e5436, _e5445);
let _e5451 = select(_e5364, _e5440, _e5446);
let _e5455 = select(_e5369, _e5413, _e5441);
let _e5457 = select(_e5371, _e5414, (_e5414 > _e5371));
let _e5464 = global_1.member.member_17.member_1;
let _e5465 = (_e5464 != 0u);
let _e5469 = global_1.member.member_17.member;
let _e5489 = select(-1e6f, (((((_e5469.member.member * _e1127) + (_e5469.member.member_1 * _e1140)) + (_e5469.member.member_2 * _e1105)) + _e5469.member_1) * _e5384), _e5465);
let _e5490 = select(-1e6f, (((((_e5469.member.member * _e1150) + (_e5469.member.member_1 * _e1155)) + (_e5469.member.member_2 * _e1144)) + _e5469.member_1) * _e5384), _e5465);
let _e5495 = global_1.member.member_17.member.member;
let _e5499 = -(_e5489);
let _e5502 = (_e5489 - _e5490);
let _e5503 = (_e5490 - _e5489);
let _e5505 = select(_e5503, _e5502, (_e5502 > _e5503));
let _e5508 = (select(_e5499, _e5489, (_e5489 > _e5499)) / select(1e-30f, _e5505, (_e5505 > 1e-30f)));
let _e5512 = select(0f, select(2f, _e5508, (_e5490 < 0f)), (_e5489 > 0f));
let _e5516 = select(2f, select(0f, _e5508, (_e5489 < 0f)), (_e5490 > 0f));
let _e5517 = (_e5489 > _e5455);
let _e5521 = ((_e5512 > _e5447) || ((_e5512 == _e5447) && _e5517));
let _e5522 = (_e5516 < _e5451);
let _e5523 = select(_e5447, _e5512, _e5521);
let _e5527 = select(_e5451, _e5516, _e5522);
let _e5531 = select(_e5455, _e5489, _e5517);
let _e5533 = select(_e5457, _e5490, (_e5490 > _e5457));
let _e5540 = global_1.member.member_18.member_1;
let _e5541 = (_e5540 != 0u);
let _e5545 = global_1.member.member_18.member;
let _e5565 = select(-1e6f, (((((_e5545.member.member * _e1127) + (_e5545.member.member_1 * _e1140)) + (_e5545.member.member_2 * _e1105)) + _e5545.member_1) * _e5384), _e5541);
let _e5566 = select(-1e6f, (((((_e5545.member.member * _e1150) + (_e5545.member.member_1 * _e1155)) + (_e5545.member.member_2 * _e1144)) + _e5545.member_1) * _e5384), _e5541);
let _e5571 = global_1.member.member_18.member.member;
let _e5575 = -(_e5565);
let _e5578 = (_e5565 - _e5566);
let _e5579 = (_e5566 - _e5565);
let _e5581 = select(_e5579, _e5578, (_e5578 > _e5579));
let _e5584 = (select(_e5575, _e5565, (_e5565 > _e5575)) / select(1e-30f, _e5581, (_e5581 > 1e-30f)));
let _e5588 = select(0f, select(2f, _e5584, (_e5566 < 0f)), (_e5565 > 0f));
let _e5592 = select(2f, select(0f, _e5584, (_e5565 < 0f)), (_e5566 > 0f));
let _e5593 = (_e5565 > _e5531);
let _e5597 = ((_e5588 > _e5523) || ((_e5588 == _e5523) && _e5593));
let _e5598 = (_e5592 < _e5527);
let _e5599 = select(_e5523, _e5588, _e5597);
let _e5603 = select(_e5527, _e5592, _e5598);
let _e5607 = select(_e5531, _e5565, _e5593);
let _e5609 = select(_e5533, _e5566, (_e5566 > _e5533));
let _e5616 = global_1.member.member_19.member_1;
let _e5617 = (_e5616 != 0u);
let _e5621 = global_1.member.member_19.member;
let _e5641 = select(-1e6f, (((((_e5621.member.member * _e1127) + (_e5621.member.member_1 * _e1140)) + (_e5621.member.member_2 * _e1105)) + _e5621.member_1) * _e5384), _e5617);
let _e5642 = select(-1e6f, (((((_e5621.member.member * _e1150) + (_e5621.member.member_1 * _e1155)) + (_e5621.member.member_2 * _e1144)) + _e5621.member_1) * _e5384), _e5617);
let _e5647 = global_1.member.member_19.member.member;
let _e5651 = -(_e5641);
let _e5654 = (_e5641 - _e5642);
let _e5655 = (_e5642 - _e5641);
let _e5657 = select(_e5655, _e5654, (_e5654 > _e5655));
let _e5660 = (select(_e5651, _e5641, (_e5641 > _e5651)) / select(1e-30f, _e5657, (_e5657 > 1e-30f)));
let _e5664 = select(0f, select(2f, _e5660, (_e5642 < 0f)), (_e5641 > 0f));
let _e5668 = select(2f, select(0f, _e5660, (_e5641 < 0f)), (_e5642 > 0f));
let _e5669 = (_e5641 > _e5607);
let _e5673 = ((_e5664 > _e5599) || ((_e5664 == _e5599) && _e5669));
let _e5674 = (_e5668 < _e5603);
phi_13579_ = type_34(select(_e5599, _e5664, _e5673), vec3<f32>(select(select(select(select(_e5360, _e5419.member, _e5445), _e5495.member, _e5521), _e5571.member, _e5597), _e5647.member, _e5673), select(select(select(select(_e5361, _e5419.member_1, _e5445), _e5495.member_1, _e5521), _e5571.member_1, _e5597), _e5647.member_1, _e5673), select(select(select(select(_e5362, _e5419.member_2, _e5445), _e5495.member_2, _e5521), _e5571.member_2, _e5597), _e5647.member_2, _e5673)), select(_e5603, _e5668, _e5674), vec3<f32>(select(select(select(select(_e5365, _e5419.member, _e5446), _e5495.member, _e5522), _e5571.member, _e5598), _e5647.member, _e5674), select(select(select(select(_e5366, _e5419.member_1, _e5446), _e5495.member_1, _e5522), _e5571.member_1, _e5598), _e5647.member_1, _e5674), select(select(select(select(_e5367, _e5419.member_2, _e5446), _e5495.member_2, _e5522), _e5571.member_2, _e5598), _e5647.member_2, _e5674)), select(_e5607, _e5641, _e5669), select(_e5609, _e5642, (_e5642 > _e5609)), vec3<f32>(select(select(select(select(_e5372, _e5419.member, _e5441), _e5495.member, _e5517), _e5571.member, _e5593), _e5647.member, _e5669), select(select(select(select(_e5373, _e5419.member_1, _e5441), _e5495.member_1, _e5517), _e5571.member_1, _e5593), _e5647.member_1, _e5669), select(select(select(select(_e5374, _e5419.member_2, _e5441), _e5495.member_2, _e5517), _e5571.member_2, _e5593), _e5647.member_2, _e5669)));
}
let _e5694 = phi_13579_;
let _e5696 = (_e5694.member_4 < 0f);
let _e5698 = (_e5694.member_5 < 0f);
let _e5699 = (_e5696 != _e5698);
if _e5696 {
phi_13592_ = _e5694.member_3;
phi_13593_ = _e5694.member_2;
} else {
phi_13592_ = _e5694.member_1;
phi_13593_ = _e5694.member;
}
let _e5705 = phi_13592_;
let _e5707 = phi_13593_;
let _e5716 = (((_e5116.member * _e5116.member) + (_e5116.member_1 * _e5116.member_1)) + (_e5116.member_2 * _e5116.member_2));
let _e5719 = sqrt(select(0f, _e5716, (_e5716 > 0f)));
let _e5720 = ((1.5f * _e1125) * _e5719);
let _e5725 = select(0f, _e5707, _e5699);
let _e5729 = (_e1127 + (_e3634 * _e5725));
let _e5730 = (_e1140 + (_e3635 * _e5725));
let _e5731 = (_e1105 + (_e3636 * _e5725));
let _e5737 = ((((_e1159.member.member * _e5729) + (_e1159.member.member_1 * _e5730)) + (_e1159.member.member_2 * _e5731)) + _e1159.member_1);
let _e5743 = ((((_e1174.member.member * _e5729) + (_e1174.member.member_1 * _e5730)) + (_e1174.member.member_2 * _e5731)) + _e1174.member_1);
let _e5749 = ((((_e1189.member.member * _e5729) + (_e1189.member.member_1 * _e5730)) + (_e1189.member.member_2 * _e5731)) + _e1189.member_1);
let _e5751 = select(-0.5f, _e5737, (_e5737 > -0.5f));
let _e5753 = select(_e3056, _e5751, (_e5751 < _e3056));
let _e5755 = select(-0.5f, _e5743, (_e5743 > -0.5f));
let _e5757 = select(_e3066, _e5755, (_e5755 < _e3066));
let _e5759 = select(-0.5f, _e5749, (_e5749 > -0.5f));
let _e5761 = select(_e3076, _e5759, (_e5759 < _e3076));
let _e5763 = select(-1f, _e5753, (_e5753 > -1f));
let _e5765 = select(_e3055, _e5763, (_e5763 < _e3055));
let _e5772 = select(0i, select(select(i32(_e5765), i32(-2147483648), (_e5765 < -2147483600f)), 2147483647i, (_e5765 > 2147483500f)), (_e5765 == _e5765));
let _e5776 = (_e5772 - select(0i, 1i, (_e5765 < f32(_e5772))));
let _e5778 = select(-1f, _e5757, (_e5757 > -1f));
let _e5780 = select(_e3065, _e5778, (_e5778 < _e3065));
let _e5787 = select(0i, select(select(i32(_e5780), i32(-2147483648), (_e5780 < -2147483600f)), 2147483647i, (_e5780 > 2147483500f)), (_e5780 == _e5780));
let _e5791 = (_e5787 - select(0i, 1i, (_e5780 < f32(_e5787))));
let _e5793 = select(-1f, _e5761, (_e5761 > -1f));
let _e5795 = select(_e3075, _e5793, (_e5793 < _e3075));
let _e5802 = select(0i, select(select(i32(_e5795), i32(-2147483648), (_e5795 < -2147483600f)), 2147483647i, (_e5795 > 2147483500f)), (_e5795 == _e5795));
let _e5806 = (_e5802 - select(0i, 1i, (_e5795 < f32(_e5802))));
let _e5809 = (_e5791 + 1i);
let _e5814 = (_e5806 + 1i);
let _e5817 = (_e5776 - 1i);
let _e5822 = (_e5776 + 1i);
let _e5825 = (_e5776 + 2i);
let _e5828 = (select(0i, _e5791, (_e5791 > 0i)) * _e3129);
let _e5829 = (select(_e3141, _e5809, (_e5809 < _e3141)) * _e3129);
let _e5830 = (select(0i, _e5806, (_e5806 > 0i)) * _e3133);
let _e5831 = (select(_e3154, _e5814, (_e5814 < _e3154)) * _e3133);
local_2 = type_29(array<i32, 4>(select(0i, _e5817, (_e5817 > 0i)), select(0i, _e5776, (_e5776 > 0i)), select(_e3167, _e5822, (_e5822 < _e3167)), select(_e3167, _e5825, (_e5825 < _e3167))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e5753 - f32(_e5776)), (_e5757 - f32(_e5791)), (_e5761 - f32(_e5806)));
let _e5842 = (_e5830 + _e5828);
let _e5845 = local_2.member[1u];
let _e5846 = (_e5842 + _e5845);
let _e5848 = select(_e3199, _e5846, (_e5846 < _e3199));
let _e5853 = global_2.member[bitcast<u32>(select(0i, _e5848, (_e5848 > 0i)))];
let _e5854 = bitcast<f32>(_e5853);
let _e5857 = local_2.member[2u];
let _e5858 = (_e5842 + _e5857);
let _e5860 = select(_e3199, _e5858, (_e5858 < _e3199));
let _e5865 = global_2.member[bitcast<u32>(select(0i, _e5860, (_e5860 > 0i)))];
let _e5867 = local_3[0u];
let _e5870 = (_e5854 + ((bitcast<f32>(_e5865) - _e5854) * _e5867));
let _e5871 = (_e5830 + _e5829);
let _e5872 = local_2.member[1u];
let _e5873 = (_e5871 + _e5872);
let _e5875 = select(_e3199, _e5873, (_e5873 < _e3199));
let _e5880 = global_2.member[bitcast<u32>(select(0i, _e5875, (_e5875 > 0i)))];
let _e5881 = bitcast<f32>(_e5880);
let _e5882 = local_2.member[2u];
let _e5883 = (_e5871 + _e5882);
let _e5885 = select(_e3199, _e5883, (_e5883 < _e3199));
let _e5890 = global_2.member[bitcast<u32>(select(0i, _e5885, (_e5885 > 0i)))];
let _e5892 = local_3[0u];
let _e5897 = local_3[1u];
let _e5900 = (_e5870 + (((_e5881 + ((bitcast<f32>(_e5890) - _e5881) * _e5892)) - _e5870) * _e5897));
let _e5901 = (_e5831 + _e5828);
let _e5902 = local_2.member[1u];
let _e5903 = (_e5901 + _e5902);
let _e5905 = select(_e3199, _e5903, (_e5903 < _e3199));
let _e5910 = global_2.member[bitcast<u32>(select(0i, _e5905, (_e5905 > 0i)))];
let _e5911 = bitcast<f32>(_e5910);
let _e5912 = local_2.member[2u];
let _e5913 = (_e5901 + _e5912);
let _e5915 = select(_e3199, _e5913, (_e5913 < _e3199));
let _e5920 = global_2.member[bitcast<u32>(select(0i, _e5915, (_e5915 > 0i)))];
let _e5922 = local_3[0u];
let _e5925 = (_e5911 + ((bitcast<f32>(_e5920) - _e5911) * _e5922));
let _e5926 = (_e5831 + _e5829);
let _e5927 = local_2.member[1u];
let _e5928 = (_e5926 + _e5927);
let _e5930 = select(_e3199, _e5928, (_e5928 < _e3199));
let _e5935 = global_2.member[bitcast<u32>(select(0i, _e5930, (_e5930 > 0i)))];
let _e5936 = bitcast<f32>(_e5935);
let _e5937 = local_2.member[2u];
let _e5938 = (_e5926 + _e5937);
let _e5940 = select(_e3199, _e5938, (_e5938 < _e3199));
let _e5945 = global_2.member[bitcast<u32>(select(0i, _e5940, (_e5940 > 0i)))];
let _e5947 = local_3[0u];
let _e5951 = local_3[1u];
let _e5956 = local_3[2u];
let _e5961 = (((_e5900 + (((_e5925 + (((_e5936 + ((bitcast<f32>(_e5945) - _e5936) * _e5947)) - _e5925) * _e5951)) - _e5900) * _e5956)) - _e3316) * _e3320);
let _e5963 = select(_e3323, _e5961, (_e5961 > _e3323));
local = select(1e9f, _e5963, (_e5963 < 1e9f));
let _e5966 = local;
local_1 = _e5966;
let _e5967 = local_1;
let _e5969 = (bitcast<i32>(_e163) - 1i);
let _e5971 = select(_e5969, 263197i, (263197i < _e5969));
let _e5976 = global_3.member[bitcast<u32>(select(0i, _e5971, (_e5971 > 0i)))];
let _e5979 = select(_e5969, 263198i, (263198i < _e5969));
let _e5984 = global_3.member[bitcast<u32>(select(0i, _e5979, (_e5979 > 0i)))];
let _e5987 = select(_e5969, 263199i, (263199i < _e5969));
let _e5992 = global_3.member[bitcast<u32>(select(0i, _e5987, (_e5987 > 0i)))];
let _e5993 = bitcast<f32>(_e5992);
let _e5995 = ((_e5967 - bitcast<f32>(_e5976)) * bitcast<f32>(_e5984));
let _e5997 = select(0f, _e5995, (_e5995 > 0f));
let _e6000 = local_1;
let _e6002 = select(_e5969, 263200i, (263200i < _e5969));
let _e6007 = global_3.member[bitcast<u32>(select(0i, _e6002, (_e6002 > 0i)))];
let _e6010 = select(_e5969, 263201i, (263201i < _e5969));
let _e6015 = global_3.member[bitcast<u32>(select(0i, _e6010, (_e6010 > 0i)))];
let _e6018 = select(_e5969, 263202i, (263202i < _e5969));
let _e6023 = global_3.member[bitcast<u32>(select(0i, _e6018, (_e6018 > 0i)))];
let _e6024 = bitcast<f32>(_e6023);
let _e6026 = ((_e6000 - bitcast<f32>(_e6007)) * bitcast<f32>(_e6015));
let _e6028 = select(0f, _e6026, (_e6026 > 0f));
let _e6032 = local_1;
let _e6034 = select(_e5969, 263203i, (263203i < _e5969));
let _e6039 = global_3.member[bitcast<u32>(select(0i, _e6034, (_e6034 > 0i)))];
let _e6042 = select(_e5969, 263204i, (263204i < _e5969));
let _e6047 = global_3.member[bitcast<u32>(select(0i, _e6042, (_e6042 > 0i)))];
let _e6050 = select(_e5969, 263205i, (263205i < _e5969));
let _e6055 = global_3.member[bitcast<u32>(select(0i, _e6050, (_e6050 > 0i)))];
let _e6056 = bitcast<f32>(_e6055);
let _e6058 = ((_e6032 - bitcast<f32>(_e6039)) * bitcast<f32>(_e6047));
let _e6060 = select(0f, _e6058, (_e6058 > 0f));
let _e6063 = local_1;
let _e6065 = select(_e5969, 263206i, (263206i < _e5969));
let _e6070 = global_3.member[bitcast<u32>(select(0i, _e6065, (_e6065 > 0i)))];
let _e6073 = select(_e5969, 263207i, (263207i < _e5969));
let _e6078 = global_3.member[bitcast<u32>(select(0i, _e6073, (_e6073 > 0i)))];
let _e6081 = select(_e5969, 263208i, (263208i < _e5969));
let _e6086 = global_3.member[bitcast<u32>(select(0i, _e6081, (_e6081 > 0i)))];
let _e6087 = bitcast<f32>(_e6086);
let _e6089 = ((_e6063 - bitcast<f32>(_e6070)) * bitcast<f32>(_e6078));
let _e6091 = select(0f, _e6089, (_e6089 > 0f));
let _e6095 = ((select(_e5993, _e5997, (_e5997 < _e5993)) + select(_e6024, _e6028, (_e6028 < _e6024))) + (select(_e6056, _e6060, (_e6060 < _e6056)) + select(_e6087, _e6091, (_e6091 < _e6087))));
let _e6097 = select(0f, _e6095, (_e6095 > 0f));
let _e6099 = select(1023f, _e6097, (_e6097 < 1023f));
let _e6106 = select(0i, select(select(i32(_e6099), i32(-2147483648), (_e6099 < -2147483600f)), 2147483647i, (_e6099 > 2147483500f)), (_e6099 == _e6099));
let _e6110 = (_e6106 - select(0i, 1i, (_e6099 < f32(_e6106))));
let _e6111 = (262147i + _e6110);
let _e6113 = select(_e5969, _e6111, (_e6111 < _e5969));
let _e6119 = global_3.member[bitcast<u32>(select(0i, _e6113, (_e6113 > 0i)))];
let _e6129 = select(_e5969, 262146i, (262146i < _e5969));
let _e6135 = global_3.member[bitcast<u32>(select(0i, _e6129, (_e6129 > 0i)))];
let _e6139 = select(_e5969, 262144i, (262144i < _e5969));
let _e6145 = global_3.member[bitcast<u32>(select(0i, _e6139, (_e6139 > 0i)))];
let _e6148 = select(_e5969, 262145i, (262145i < _e5969));
let _e6154 = global_3.member[bitcast<u32>(select(0i, _e6148, (_e6148 > 0i)))];
let _e6161 = ((bitcast<f32>(_e6145) + (f32(bitcast<i32>((_e6119 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6154))) + ((f32((bitcast<i32>((_e6119 & 4095u)) - 2048i)) * bitcast<f32>(_e6135)) * (_e6095 - f32(_e6110))));
let _e6165 = select(_e5694.member_6.x, _e5705.x, _e5699);
let _e6168 = select(_e5694.member_6.y, _e5705.y, _e5699);
let _e6171 = select(_e5694.member_6.z, _e5705.z, _e5699);
let _e6172 = select(1f, _e6161, _e5698);
let _e6177 = (((_e6165 * _e6165) + (_e6168 * _e6168)) + (_e6171 * _e6171));
let _e6180 = sqrt(select(0f, _e6177, (_e6177 > 0f)));
let _e6183 = (1f / select(1e-20f, _e6180, (_e6180 > 1e-20f)));
let _e6184 = (_e6165 * _e6183);
let _e6185 = (_e6168 * _e6183);
let _e6186 = (_e6171 * _e6183);
let _e6191 = (((_e231 * _e6184) + (_e242 * _e6185)) + (_e253 * _e6186));
let _e6196 = (((_e231 * _e231) + (_e242 * _e242)) + (_e253 * _e253));
let _e6198 = ((_e6172 * _e6172) - _e6196);
let _e6199 = (_e6191 * _e6191);
let _e6200 = (_e6199 + _e6198);
let _e6203 = sqrt(select(0f, _e6200, (_e6200 > 0f)));
let _e6207 = (_e6200 <= 0f);
let _e6210 = select((select(_e6203, -(_e6203), (_e6191 < 0f)) - _e6191), (-2f * _e6191), _e6207);
let _e6211 = (_e6198 == 0f);
let _e6222 = (_e6207 && (_e6198 != 0f));
let _e6228 = (!(_e5699) && (_e6222 || (_e6199 < ((0.1f * 0.1f) * _e6196))));
let _e6230 = select(1e-12f, _e6196, (_e6196 > 1e-12f));
let _e6234 = (_e6172 / sqrt(select(0f, _e6230, (_e6230 > 0f))));
let _e6246 = ((_e5699 || (bitcast<f32>((bitcast<u32>(_e5694.member_4) & 2147483647u)) < select(1f, _e5720, (_e5720 < 1f)))) && (_e6161 != 1f));
let _e6247 = select(_e231, select(select(select((_e231 + (_e6184 * _e6210)), _e231, _e6211), _e231, _e6222), (_e231 * _e6234), _e6228), _e6246);
let _e6248 = select(_e242, select(select(select((_e242 + (_e6185 * _e6210)), _e242, _e6211), _e242, _e6222), (_e242 * _e6234), _e6228), _e6246);
let _e6249 = select(_e253, select(select(select((_e253 + (_e6186 * _e6210)), _e253, _e6211), _e253, _e6222), (_e253 * _e6234), _e6228), _e6246);
let _e6261 = global_1.member.member_7.member_2;
let _e6264 = (_e6261 / select(1e-6f, _e6249, (_e6249 > 1e-6f)));
let _e6268 = (_e1150 + (_e6247 * _e6264));
let _e6269 = (_e1155 + (_e6248 * _e6264));
let _e6270 = (_e1144 + (_e6249 * _e6264));
let _e6276 = ((((_e1159.member.member * _e6268) + (_e1159.member.member_1 * _e6269)) + (_e1159.member.member_2 * _e6270)) + _e1159.member_1);
let _e6282 = ((((_e1174.member.member * _e6268) + (_e1174.member.member_1 * _e6269)) + (_e1174.member.member_2 * _e6270)) + _e1174.member_1);
let _e6288 = ((((_e1189.member.member * _e6268) + (_e1189.member.member_1 * _e6269)) + (_e1189.member.member_2 * _e6270)) + _e1189.member_1);
let _e6289 = (-0.5f - _e6276);
let _e6290 = -(_e5136);
let _e6293 = (_e5136 - _e6289);
let _e6294 = (_e6289 - _e5136);
let _e6296 = select(_e6294, _e6293, (_e6293 > _e6294));
let _e6299 = (select(_e6290, _e5136, (_e5136 > _e6290)) / select(1e-30f, _e6296, (_e6296 > 1e-30f)));
let _e6302 = select(0f, select(2f, _e6299, (_e6289 < 0f)), _e5151);
let _e6305 = select(2f, select(0f, _e6299, _e5148), (_e6289 > 0f));
let _e6309 = ((_e6302 > -1f) || ((_e6302 == -1f) && _e5170));
let _e6310 = (_e6305 < 2f);
let _e6311 = select(-1f, _e6302, _e6309);
let _e6315 = select(2f, _e6305, _e6310);
let _e6320 = select(-1e30f, _e6289, (_e6289 > -1e30f));
let _e6324 = (_e6276 - _e3056);
let _e6325 = -(_e5176);
let _e6328 = (_e5176 - _e6324);
let _e6329 = (_e6324 - _e5176);
let _e6331 = select(_e6329, _e6328, (_e6328 > _e6329));
let _e6334 = (select(_e6325, _e5176, (_e5176 > _e6325)) / select(1e-30f, _e6331, (_e6331 > 1e-30f)));
let _e6337 = select(0f, select(2f, _e6334, (_e6324 < 0f)), _e5191);
let _e6340 = select(2f, select(0f, _e6334, _e5188), (_e6324 > 0f));
let _e6344 = ((_e6337 > _e6311) || ((_e6337 == _e6311) && _e5210));
let _e6345 = (_e6340 < _e6315);
let _e6346 = select(_e6311, _e6337, _e6344);
let _e6350 = select(_e6315, _e6340, _e6345);
let _e6355 = select(_e6320, _e6324, (_e6324 > _e6320));
let _e6359 = (-0.5f - _e6282);
let _e6360 = -(_e5215);
let _e6363 = (_e5215 - _e6359);
let _e6364 = (_e6359 - _e5215);
let _e6366 = select(_e6364, _e6363, (_e6363 > _e6364));
let _e6369 = (select(_e6360, _e5215, (_e5215 > _e6360)) / select(1e-30f, _e6366, (_e6366 > 1e-30f)));
let _e6372 = select(0f, select(2f, _e6369, (_e6359 < 0f)), _e5230);
let _e6375 = select(2f, select(0f, _e6369, _e5227), (_e6359 > 0f));
let _e6379 = ((_e6372 > _e6346) || ((_e6372 == _e6346) && _e5249));
let _e6380 = (_e6375 < _e6350);
let _e6381 = select(_e6346, _e6372, _e6379);
let _e6385 = select(_e6350, _e6375, _e6380);
let _e6390 = select(_e6355, _e6359, (_e6359 > _e6355));
let _e6394 = (_e6282 - _e3066);
let _e6395 = -(_e5255);
let _e6398 = (_e5255 - _e6394);
let _e6399 = (_e6394 - _e5255);
let _e6401 = select(_e6399, _e6398, (_e6398 > _e6399));
let _e6404 = (select(_e6395, _e5255, (_e5255 > _e6395)) / select(1e-30f, _e6401, (_e6401 > 1e-30f)));
let _e6407 = select(0f, select(2f, _e6404, (_e6394 < 0f)), _e5270);
let _e6410 = select(2f, select(0f, _e6404, _e5267), (_e6394 > 0f));
let _e6414 = ((_e6407 > _e6381) || ((_e6407 == _e6381) && _e5289));
let _e6415 = (_e6410 < _e6385);
let _e6416 = select(_e6381, _e6407, _e6414);
let _e6420 = select(_e6385, _e6410, _e6415);
let _e6425 = select(_e6390, _e6394, (_e6394 > _e6390));
let _e6429 = (-0.5f - _e6288);
let _e6430 = -(_e5294);
let _e6433 = (_e5294 - _e6429);
let _e6434 = (_e6429 - _e5294);
let _e6436 = select(_e6434, _e6433, (_e6433 > _e6434));
let _e6439 = (select(_e6430, _e5294, (_e5294 > _e6430)) / select(1e-30f, _e6436, (_e6436 > 1e-30f)));
let _e6442 = select(0f, select(2f, _e6439, (_e6429 < 0f)), _e5309);
let _e6445 = select(2f, select(0f, _e6439, _e5306), (_e6429 > 0f));
let _e6449 = ((_e6442 > _e6416) || ((_e6442 == _e6416) && _e5328));
let _e6450 = (_e6445 < _e6420);
let _e6451 = select(_e6416, _e6442, _e6449);
let _e6455 = select(_e6420, _e6445, _e6450);
let _e6460 = select(_e6425, _e6429, (_e6429 > _e6425));
let _e6464 = (_e6288 - _e3076);
let _e6465 = -(_e5334);
let _e6468 = (_e5334 - _e6464);
let _e6469 = (_e6464 - _e5334);
let _e6471 = select(_e6469, _e6468, (_e6468 > _e6469));
let _e6474 = (select(_e6465, _e5334, (_e5334 > _e6465)) / select(1e-30f, _e6471, (_e6471 > 1e-30f)));
let _e6477 = select(0f, select(2f, _e6474, (_e6464 < 0f)), _e5349);
let _e6480 = select(2f, select(0f, _e6474, _e5346), (_e6464 > 0f));
let _e6484 = ((_e6477 > _e6451) || ((_e6477 == _e6451) && _e5370));
let _e6485 = (_e6480 < _e6455);
let _e6486 = select(_e6451, _e6477, _e6484);
let _e6487 = select(select(select(select(select(select(0f, _e5116.member, _e6309), _e5116.member, _e6344), _e5124.member, _e6379), _e5124.member, _e6414), _e5132.member, _e6449), _e5132.member, _e6484);
let _e6488 = select(select(select(select(select(select(0f, _e5116.member_1, _e6309), _e5116.member_1, _e6344), _e5124.member_1, _e6379), _e5124.member_1, _e6414), _e5132.member_1, _e6449), _e5132.member_1, _e6484);
let _e6489 = select(select(select(select(select(select(1f, _e5116.member_2, _e6309), _e5116.member_2, _e6344), _e5124.member_2, _e6379), _e5124.member_2, _e6414), _e5132.member_2, _e6449), _e5132.member_2, _e6484);
let _e6491 = select(_e6455, _e6480, _e6485);
let _e6492 = select(select(select(select(select(select(0f, _e5116.member, _e6310), _e5116.member, _e6345), _e5124.member, _e6380), _e5124.member, _e6415), _e5132.member, _e6450), _e5132.member, _e6485);
let _e6493 = select(select(select(select(select(select(0f, _e5116.member_1, _e6310), _e5116.member_1, _e6345), _e5124.member_1, _e6380), _e5124.member_1, _e6415), _e5132.member_1, _e6450), _e5132.member_1, _e6485);
let _e6494 = select(select(select(select(select(select(1f, _e5116.member_2, _e6310), _e5116.member_2, _e6345), _e5124.member_2, _e6380), _e5124.member_2, _e6415), _e5132.member_2, _e6450), _e5132.member_2, _e6485);
let _e6497 = select(_e6460, _e6464, (_e6464 > _e6460));
let _e6498 = select(select(select(select(select(select(0f, _e5116.member, _e5170), _e5116.member, _e5210), _e5124.member, _e5249), _e5124.member, _e5289), _e5132.member, _e5328), _e5132.member, _e5370);
let _e6499 = select(select(select(select(select(select(0f, _e5116.member_1, _e5170), _e5116.member_1, _e5210), _e5124.member_1, _e5249), _e5124.member_1, _e5289), _e5132.member_1, _e5328), _e5132.member_1, _e5370);
let _e6500 = select(select(select(select(select(select(1f, _e5116.member_2, _e5170), _e5116.member_2, _e5210), _e5124.member_2, _e5249), _e5124.member_2, _e5289), _e5132.member_2, _e5328), _e5132.member_2, _e5370);
if _e3332 {
phi_16209_ = type_34(_e6486, vec3<f32>(_e6487, _e6488, _e6489), _e6491, vec3<f32>(_e6492, _e6493, _e6494), _e5371, _e6497, vec3<f32>(_e6498, _e6499, _e6500));
} else {
let _e6506 = global_1.member.member_16.member_1;
let _e6507 = (_e6506 != 0u);
let _e6511 = global_1.member.member_16.member;
let _e6531 = select(-1e6f, (((((_e6511.member.member * _e1150) + (_e6511.member.member_1 * _e1155)) + (_e6511.member.member_2 * _e1144)) + _e6511.member_1) * _e5719), _e6507);
let _e6532 = select(-1e6f, (((((_e6511.member.member * _e6268) + (_e6511.member.member_1 * _e6269)) + (_e6511.member.member_2 * _e6270)) + _e6511.member_1) * _e5719), _e6507);
let _e6537 = global_1.member.member_16.member.member;
let _e6541 = -(_e6531);
let _e6544 = (_e6531 - _e6532);
let _e6545 = (_e6532 - _e6531);
let _e6547 = select(_e6545, _e6544, (_e6544 > _e6545));
let _e6550 = (select(_e6541, _e6531, (_e6531 > _e6541)) / select(1e-30f, _e6547, (_e6547 > 1e-30f)));
let _e6554 = select(0f, select(2f, _e6550, (_e6532 < 0f)), (_e6531 > 0f));
let _e6558 = select(2f, select(0f, _e6550, (_e6531 < 0f)), (_e6532 > 0f));
let _e6559 = (_e6531 > _e5371);
let _e6563 = ((_e6554 > _e6486) || ((_e6554 == _e6486) && _e6559));
let _e6564 = (_e6558 < _e6491);
let _e6565 = select(_e6486, _e6554, _e6563);
let _e6569 = select(_e6491, _e6558, _e6564);
let _e6573 = select(_e5371, _e6531, _e6559);
let _e6575 = select(_e6497, _e6532, (_e6532 > _e6497));
let _e6582 = global_1.member.member_17.member_1;
let _e6583 = (_e6582 != 0u);
let _e6587 = global_1.member.member_17.member;
let _e6607 = select(-1e6f, (((((_e6587.member.member * _e1150) + (_e6587.member.member_1 * _e1155)) + (_e6587.member.member_2 * _e1144)) + _e6587.member_1) * _e5719), _e6583);
let _e6608 = select(-1e6f, (((((_e6587.member.member * _e6268) + (_e6587.member.member_1 * _e6269)) + (_e6587.member.member_2 * _e6270)) + _e6587.member_1) * _e5719), _e6583);
let _e6613 = global_1.member.member_17.member.member;
let _e6617 = -(_e6607);
let _e6620 = (_e6607 - _e6608);
let _e6621 = (_e6608 - _e6607);
let _e6623 = select(_e6621, _e6620, (_e6620 > _e6621));
let _e6626 = (select(_e6617, _e6607, (_e6607 > _e6617)) / select(1e-30f, _e6623, (_e6623 > 1e-30f)));
let _e6630 = select(0f, select(2f, _e6626, (_e6608 < 0f)), (_e6607 > 0f));
let _e6634 = select(2f, select(0f, _e6626, (_e6607 < 0f)), (_e6608 > 0f));
let _e6635 = (_e6607 > _e6573);
let _e6639 = ((_e6630 > _e6565) || ((_e6630 == _e6565) && _e6635));
let _e6640 = (_e6634 < _e6569);
let _e6641 = select(_e6565, _e6630, _e6639);
let _e6645 = select(_e6569, _e6634, _e6640);
let _e6649 = select(_e6573, _e6607, _e6635);
let _e6651 = select(_e6575, _e6608, (_e6608 > _e6575));
let _e6658 = global_1.member.member_18.member_1;
let _e6659 = (_e6658 != 0u);
let _e6663 = global_1.member.member_18.member;
let _e6683 = select(-1e6f, (((((_e6663.member.member * _e1150) + (_e6663.member.member_1 * _e1155)) + (_e6663.member.member_2 * _e1144)) + _e6663.member_1) * _e5719), _e6659);
let _e6684 = select(-1e6f, (((((_e6663.member.member * _e6268) + (_e6663.member.member_1 * _e6269)) + (_e6663.member.member_2 * _e6270)) + _e6663.member_1) * _e5719), _e6659);
let _e6689 = global_1.member.member_18.member.member;
let _e6693 = -(_e6683);
let _e6696 = (_e6683 - _e6684);
let _e6697 = (_e6684 - _e6683);
let _e6699 = select(_e6697, _e6696, (_e6696 > _e6697));
let _e6702 = (select(_e6693, _e6683, (_e6683 > _e6693)) / select(1e-30f, _e6699, (_e6699 > 1e-30f)));
let _e6706 = select(0f, select(2f, _e6702, (_e6684 < 0f)), (_e6683 > 0f));
let _e6710 = select(2f, select(0f, _e6702, (_e6683 < 0f)), (_e6684 > 0f));
let _e6711 = (_e6683 > _e6649);
let _e6715 = ((_e6706 > _e6641) || ((_e6706 == _e6641) && _e6711));
let _e6716 = (_e6710 < _e6645);
let _e6717 = select(_e6641, _e6706, _e6715);
let _e6721 = select(_e6645, _e6710, _e6716);
let _e6725 = select(_e6649, _e6683, _e6711);
let _e6727 = select(_e6651, _e6684, (_e6684 > _e6651));
let _e6734 = global_1.member.member_19.member_1;
let _e6735 = (_e6734 != 0u);
let _e6739 = global_1.member.member_19.member;
let _e6759 = select(-1e6f, (((((_e6739.member.member * _e1150) + (_e6739.member.member_1 * _e1155)) + (_e6739.member.member_2 * _e1144)) + _e6739.member_1) * _e5719), _e6735);
let _e6760 = select(-1e6f, (((((_e6739.member.member * _e6268) + (_e6739.member.member_1 * _e6269)) + (_e6739.member.member_2 * _e6270)) + _e6739.member_1) * _e5719), _e6735);
let _e6765 = global_1.member.member_19.member.member;
let _e6769 = -(_e6759);
let _e6772 = (_e6759 - _e6760);
let _e6773 = (_e6760 - _e6759);
let _e6775 = select(_e6773, _e6772, (_e6772 > _e6773));
let _e6778 = (select(_e6769, _e6759, (_e6759 > _e6769)) / select(1e-30f, _e6775, (_e6775 > 1e-30f)));
let _e6782 = select(0f, select(2f, _e6778, (_e6760 < 0f)), (_e6759 > 0f));
let _e6786 = select(2f, select(0f, _e6778, (_e6759 < 0f)), (_e6760 > 0f));
let _e6787 = (_e6759 > _e6725);
let _e6791 = ((_e6782 > _e6717) || ((_e6782 == _e6717) && _e6787));
let _e6792 = (_e6786 < _e6721);
phi_16209_ = type_34(select(_e6717, _e6782, _e6791), vec3<f32>(select(select(select(select(_e6487, _e6537.member, _e6563), _e6613.member, _e6639), _e6689.member, _e6715), _e6765.member, _e6791), select(select(select(select(_e6488, _e6537.member_1, _e6563), _e6613.member_1, _e6639), _e6689.member_1, _e6715), _e6765.member_1, _e6791), select(select(select(select(_e6489, _e6537.member_2, _e6563), _e6613.member_2, _e6639), _e6689.member_2, _e6715), _e6765.member_2, _e6791)), select(_e6721, _e6786, _e6792), vec3<f32>(select(select(select(select(_e6492, _e6537.member, _e6564), _e6613.member, _e6640), _e6689.member, _e6716), _e6765.member, _e6792), select(select(select(select(_e6493, _e6537.member_1, _e6564), _e6613.member_1, _e6640), _e6689.member_1, _e6716), _e6765.member_1, _e6792), select(select(select(select(_e6494, _e6537.member_2, _e6564), _e6613.member_2, _e6640), _e6689.member_2, _e6716), _e6765.member_2, _e6792)), select(_e6725, _e6759, _e6787), select(_e6727, _e6760, (_e6760 > _e6727)), vec3<f32>(select(select(select(select(_e6498, _e6537.member, _e6559), _e6613.member, _e6635), _e6689.member, _e6711), _e6765.member, _e6787), select(select(select(select(_e6499, _e6537.member_1, _e6559), _e6613.member_1, _e6635), _e6689.member_1, _e6711), _e6765.member_1, _e6787), select(select(select(select(_e6500, _e6537.member_2, _e6559), _e6613.member_2, _e6635), _e6689.member_2, _e6711), _e6765.member_2, _e6787)));
}
let _e6812 = phi_16209_;
let _e6821 = global_1.member.member_7.member_4;
let _e6824 = (_e3050.member_3.x * _e3535.member_2);
let _e6826 = (_e3050.member_3.y * _e3535.member_2);
let _e6828 = (_e3050.member_3.z * _e3535.member_2);
let _e6829 = (0.5f * (_e6264 * select(1f, (2f * (1f - _e5707)), (_e5699 && _e5698))));
let _e6833 = (_e6247 + (_e6824 * _e6829));
let _e6834 = (_e6248 + (_e6826 * _e6829));
let _e6835 = (_e6249 + (_e6828 * _e6829));
let _e6837 = (2f * _e6261);
let _e6839 = ((_e6835 * _e6835) + (_e6837 * _e6828));
let _e6843 = (_e6835 + sqrt(select(0f, _e6839, (_e6839 > 0f))));
let _e6847 = (select(0.5f, _e6812.member_2, (_e6812.member_2 < 1f)) * (_e6837 / select(1e-6f, _e6843, (_e6843 > 1e-6f))));
let _e6851 = (_e6833 + (_e6824 * _e6847));
let _e6852 = (_e6834 + (_e6826 * _e6847));
let _e6853 = (_e6835 + (_e6828 * _e6847));
let _e6857 = (_e6821 * _e6821);
let _e6859 = (_e6853 * _e6853);
let _e6867 = (((_e6835 <= 0f) || (_e6839 <= 0f)) || ((_e6853 <= 0f) || (_e6859 <= (_e6857 * (((_e6851 * _e6851) + (_e6852 * _e6852)) + _e6859)))));
let _e6881 = (_e6247 + ((_e3050.member_4.x * _e3535.member_2) * _e6261));
let _e6882 = (_e6248 + ((_e3050.member_4.y * _e3535.member_2) * _e6261));
let _e6883 = (_e6249 + ((_e3050.member_4.z * _e3535.member_2) * _e6261));
let _e6885 = (_e6883 * _e6883);
let _e6894 = ((_e3330 & 1u) != 0u);
let _e6899 = (select(_e6867, ((_e6883 <= 0f) || (_e6885 <= (_e6857 * (((_e6881 * _e6881) + (_e6882 * _e6882)) + _e6885)))), _e6894) || (_e6246 && ((_e6222 && _e5699) || (_e5699 && (_e6249 <= 0f)))));
phi_16361_ = vec3<f32>(select(select(select(_e6851, _e6833, _e6867), _e6881, _e6894), _e231, _e6899), select(select(select(_e6852, _e6834, _e6867), _e6882, _e6894), _e242, _e6899), select(select(select(_e6853, _e6835, _e6867), _e6883, _e6894), _e253, _e6899));
phi_16362_ = select(1f, 0f, _e6899);
} else {
phi_16361_ = vec3<f32>(_e231, _e242, _e253);
phi_16362_ = 1f;
}
let _e6906 = phi_16361_;
let _e6908 = phi_16362_;
let _e6911 = (_e5111.member * _e6908);
global_4.member[_e188] = (_e199 * (_e5111.member_2.x * _e6911));
global_4.member[_e200] = (_e209 * (_e5111.member_2.y * _e6911));
global_4.member[_e211] = (_e220 * (_e5111.member_2.z * _e6911));
global_4.member[_e222] = _e6906.x;
global_4.member[_e233] = _e6906.y;
global_4.member[_e244] = _e6906.z;
global_4.member[_e255] = _e264;
global_4.member[_e266] = _e275;
global_4.member[_e277] = _e286;
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
