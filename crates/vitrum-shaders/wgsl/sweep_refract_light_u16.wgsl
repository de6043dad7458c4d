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
var phi_899_: bool;
var phi_1079_: bool;
var phi_1082_: bool;
var phi_1266_: bool;
var phi_1589_: u32;
var phi_7460_: type_32;
var phi_8239_: type_33;
var phi_9205_: type_7;
var phi_12933_: type_35;
var phi_14252_: type_34;
var phi_14265_: vec3<f32>;
var phi_14266_: f32;
var phi_17014_: type_34;
var phi_17166_: vec3<f32>;
var phi_17167_: f32;
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
phi_899_ = _e538;
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
phi_899_ = (_e538 && (((((((((_e548.member.member * _e344) + (_e548.member.member_1 * _e357)) + (_e548.member.member_2 * _e322)) + _e548.member_1) <= _e560) || (_e565 == 0u)) && ((((((_e571.member.member * _e344) + (_e571.member.member_1 * _e357)) + (_e571.member.member_2 * _e322)) + _e571.member_1) <= _e560) || (_e587 == 0u))) && ((((((_e594.member.member * _e344) + (_e594.member.member_1 * _e357)) + (_e594.member.member_2 * _e322)) + _e594.member_1) <= _e560) || (_e610 == 0u))) && ((((((_e617.member.member * _e344) + (_e617.member.member_1 * _e357)) + (_e617.member.member_2 * _e322)) + _e617.member_1) <= _e560) || (_e633 == 0u))));
}
let _e639 = phi_899_;
let _e643 = (_e367 + (_e367 - _e344));
let _e644 = (_e372 + (_e372 - _e357));
let _e645 = (_e361 + (_e361 - _e322));
let _e651 = ((((_e413.member.member * _e643) + (_e413.member.member_1 * _e644)) + (_e413.member.member_2 * _e645)) + _e413.member_1);
let _e657 = ((((_e428.member.member * _e643) + (_e428.member.member_1 * _e644)) + (_e428.member.member_2 * _e645)) + _e428.member_1);
let _e663 = ((((_e443.member.member * _e643) + (_e443.member.member_1 * _e644)) + (_e443.member.member_2 * _e645)) + _e443.member_1);
let _e674 = ((((_e651 >= _e523) && (_e651 <= _e526)) && ((_e657 >= _e523) && (_e657 <= _e530))) && ((_e663 >= _e523) && (_e663 <= _e535)));
if _e543 {
phi_1079_ = _e674;
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
phi_1079_ = (_e674 && (((((((((_e679.member.member * _e643) + (_e679.member.member_1 * _e644)) + (_e679.member.member_2 * _e645)) + _e679.member_1) <= _e691) || (_e696 == 0u)) && ((((((_e702.member.member * _e643) + (_e702.member.member_1 * _e644)) + (_e702.member.member_2 * _e645)) + _e702.member_1) <= _e691) || (_e718 == 0u))) && ((((((_e725.member.member * _e643) + (_e725.member.member_1 * _e644)) + (_e725.member.member_2 * _e645)) + _e725.member_1) <= _e691) || (_e741 == 0u))) && ((((((_e748.member.member * _e643) + (_e748.member.member_1 * _e644)) + (_e748.member.member_2 * _e645)) + _e748.member_1) <= _e691) || (_e764 == 0u))));
}
let _e770 = phi_1079_;
phi_1082_ = (_e513 && (_e639 && _e770));
} else {
phi_1082_ = _e513;
}
let _e774 = phi_1082_;
let _e781 = ((((_e413.member.member * _e407) + (_e413.member.member_1 * _e408)) + (_e413.member.member_2 * _e409)) + _e413.member_1);
let _e787 = ((((_e428.member.member * _e407) + (_e428.member.member_1 * _e408)) + (_e428.member.member_2 * _e409)) + _e428.member_1);
let _e793 = ((((_e443.member.member * _e407) + (_e443.member.member_1 * _e408)) + (_e443.member.member_2 * _e409)) + _e443.member_1);
let _e794 = (_e396 - 0.5f);
let _e795 = (_e396 + 0.5f);
let _e809 = ((((_e781 >= _e794) && (_e781 <= (_e478 - _e795))) && ((_e787 >= _e794) && (_e787 <= (_e488 - _e795)))) && ((_e793 >= _e794) && (_e793 <= (_e498 - _e795))));
let _e812 = global_1.member.member_1;
if ((_e812 & 16u) == 0u) {
phi_1266_ = _e809;
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
phi_1266_ = (_e809 && (((((((((_e819.member.member * _e407) + (_e819.member.member_1 * _e408)) + (_e819.member.member_2 * _e409)) + _e819.member_1) <= _e831) || (_e836 == 0u)) && ((((((_e842.member.member * _e407) + (_e842.member.member_1 * _e408)) + (_e842.member.member_2 * _e409)) + _e842.member_1) <= _e831) || (_e858 == 0u))) && ((((((_e865.member.member * _e407) + (_e865.member.member_1 * _e408)) + (_e865.member.member_2 * _e409)) + _e865.member_1) <= _e831) || (_e881 == 0u))) && ((((((_e888.member.member * _e407) + (_e888.member.member_1 * _e408)) + (_e888.member.member_2 * _e409)) + _e888.member_1) <= _e831) || (_e904 == 0u))));
}
let _e910 = phi_1266_;
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
phi_1589_ = select(select(7u, 3u, (_e774 && (!(_e522) || _e910))), 1u, (((_e812 & 64u) != 0u) || ((((select(_e946, _e943, (_e943 > _e946)) <= _e917) && ((select(_e963, _e960, (_e960 > _e963)) > _e917) || (_e1057 != 0u))) && true) && ((_e812 & 32u) != 0u))));
} else {
phi_1589_ = 7u;
}
let _e1070 = phi_1589_;
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
let _e1355 = select(0i, select(select(i32(_e1232), i32(-2147483648), (_e1232 < -2147483600f)), 2147483647i, (_e1232 > 2147483500f)), (_e1232 == _e1232));
let _e1356 = (_e1355 - 1i);
let _e1357 = (_e1272 - 1i);
let _e1359 = select(0i, _e1357, (_e1357 > 0i));
let _e1361 = select(0i, _e1272, (_e1272 > 0i));
let _e1362 = (_e1272 + 1i);
let _e1364 = select(_e1356, _e1362, (_e1362 < _e1356));
let _e1365 = (_e1272 + 2i);
let _e1368 = (_e1355 - 2i);
let _e1370 = select(0i, _e1368, (_e1368 > 0i));
let _e1372 = select(_e1370, _e1359, (_e1359 < _e1370));
let _e1374 = select(_e1370, _e1361, (_e1361 < _e1370));
let _e1376 = select(_e1370, _e1364, (_e1364 < _e1370));
let _e1395 = (select(0i, _e1319, (_e1319 > 0i)) * _e1306);
let _e1396 = (select(0i, _e1287, (_e1287 > 0i)) * _e1306);
let _e1397 = (select(_e1318, _e1324, (_e1324 < _e1318)) * _e1306);
let _e1398 = (select(_e1318, _e1327, (_e1327 < _e1318)) * _e1306);
let _e1399 = (select(0i, _e1338, (_e1338 > 0i)) * _e1310);
let _e1400 = (select(0i, _e1302, (_e1302 > 0i)) * _e1310);
let _e1401 = (select(_e1337, _e1343, (_e1343 < _e1337)) * _e1310);
let _e1402 = (select(_e1337, _e1346, (_e1346 < _e1337)) * _e1310);
local_26 = type_29(array<i32, 4>(_e1372, _e1374, _e1376, 0i), array<u32, 6>(bitcast<u32>(((_e1359 - _e1372) * 16i)), bitcast<u32>(((_e1361 - _e1372) * 16i)), bitcast<u32>(((_e1361 - _e1374) * 16i)), bitcast<u32>(((_e1364 - _e1374) * 16i)), bitcast<u32>(((_e1364 - _e1376) * 16i)), bitcast<u32>(((select(_e1356, _e1365, (_e1365 < _e1356)) - _e1376) * 16i))));
local_27 = vec3<f32>((_e1237 - f32(_e1272)), (_e1247 - f32(_e1287)), (_e1257 - f32(_e1302)));
let _e1414 = (_e1400 + _e1396);
let _e1417 = local_26.member[0u];
let _e1418 = (_e1414 + _e1417);
let _e1420 = (_e1418 >> bitcast<u32>(1i));
let _e1423 = bitcast<u32>(((_e1418 & 1i) * 16i));
let _e1425 = (bitcast<i32>(_e158) - 1i);
let _e1427 = select(_e1425, _e1420, (_e1420 < _e1425));
let _e1432 = global_2.member[bitcast<u32>(select(0i, _e1427, (_e1427 > 0i)))];
let _e1436 = (_e1420 + 1i);
let _e1438 = select(_e1425, _e1436, (_e1436 < _e1425));
let _e1443 = global_2.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1450 = ((_e1432 >> bitcast<u32>((_e1423 & 31u))) | ((_e1443 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1423) & 31u))));
let _e1453 = local_26.member[2u];
let _e1454 = (_e1414 + _e1453);
let _e1456 = (_e1454 >> bitcast<u32>(1i));
let _e1459 = bitcast<u32>(((_e1454 & 1i) * 16i));
let _e1461 = select(_e1425, _e1456, (_e1456 < _e1425));
let _e1466 = global_2.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1470 = (_e1456 + 1i);
let _e1472 = select(_e1425, _e1470, (_e1470 < _e1425));
let _e1477 = global_2.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1484 = ((_e1466 >> bitcast<u32>((_e1459 & 31u))) | ((_e1477 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1459) & 31u))));
let _e1487 = local_26.member_1[0u];
let _e1493 = f32(bitcast<i32>(((_e1450 >> bitcast<u32>((_e1487 & 31u))) & 65535u)));
let _e1496 = local_26.member_1[1u];
let _e1502 = f32(bitcast<i32>(((_e1450 >> bitcast<u32>((_e1496 & 31u))) & 65535u)));
let _e1505 = local_26.member_1[4u];
let _e1511 = f32(bitcast<i32>(((_e1484 >> bitcast<u32>((_e1505 & 31u))) & 65535u)));
let _e1514 = local_26.member_1[5u];
let _e1521 = local_27[0u];
let _e1524 = (_e1493 + ((_e1502 - _e1493) * _e1521));
let _e1525 = local_27[0u];
let _e1528 = (_e1502 + ((_e1511 - _e1502) * _e1525));
let _e1529 = local_27[0u];
let _e1532 = (_e1511 + ((f32(bitcast<i32>(((_e1484 >> bitcast<u32>((_e1514 & 31u))) & 65535u))) - _e1511) * _e1529));
let _e1533 = (_e1400 + _e1397);
let _e1534 = local_26.member[0u];
let _e1535 = (_e1533 + _e1534);
let _e1537 = (_e1535 >> bitcast<u32>(1i));
let _e1540 = bitcast<u32>(((_e1535 & 1i) * 16i));
let _e1542 = select(_e1425, _e1537, (_e1537 < _e1425));
let _e1547 = global_2.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1551 = (_e1537 + 1i);
let _e1553 = select(_e1425, _e1551, (_e1551 < _e1425));
let _e1558 = global_2.member[bitcast<u32>(select(0i, _e1553, (_e1553 > 0i)))];
let _e1565 = ((_e1547 >> bitcast<u32>((_e1540 & 31u))) | ((_e1558 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1540) & 31u))));
let _e1566 = local_26.member[2u];
let _e1567 = (_e1533 + _e1566);
let _e1569 = (_e1567 >> bitcast<u32>(1i));
let _e1572 = bitcast<u32>(((_e1567 & 1i) * 16i));
let _e1574 = select(_e1425, _e1569, (_e1569 < _e1425));
let _e1579 = global_2.member[bitcast<u32>(select(0i, _e1574, (_e1574 > 0i)))];
let _e1583 = (_e1569 + 1i);
let _e1585 = select(_e1425, _e1583, (_e1583 < _e1425));
let _e1590 = global_2.member[bitcast<u32>(select(0i, _e1585, (_e1585 > 0i)))];
let _e1597 = ((_e1579 >> bitcast<u32>((_e1572 & 31u))) | ((_e1590 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1572) & 31u))));
let _e1598 = local_26.member_1[0u];
let _e1604 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1598 & 31u))) & 65535u)));
let _e1605 = local_26.member_1[1u];
let _e1611 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1605 & 31u))) & 65535u)));
let _e1612 = local_26.member_1[4u];
let _e1618 = f32(bitcast<i32>(((_e1597 >> bitcast<u32>((_e1612 & 31u))) & 65535u)));
let _e1619 = local_26.member_1[5u];
let _e1626 = local_27[0u];
let _e1630 = local_27[0u];
let _e1633 = (_e1611 + ((_e1618 - _e1611) * _e1630));
let _e1634 = local_27[0u];
let _e1638 = (_e1401 + _e1396);
let _e1639 = local_26.member[0u];
let _e1640 = (_e1638 + _e1639);
let _e1642 = (_e1640 >> bitcast<u32>(1i));
let _e1645 = bitcast<u32>(((_e1640 & 1i) * 16i));
let _e1647 = select(_e1425, _e1642, (_e1642 < _e1425));
let _e1652 = global_2.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1656 = (_e1642 + 1i);
let _e1658 = select(_e1425, _e1656, (_e1656 < _e1425));
let _e1663 = global_2.member[bitcast<u32>(select(0i, _e1658, (_e1658 > 0i)))];
let _e1670 = ((_e1652 >> bitcast<u32>((_e1645 & 31u))) | ((_e1663 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1645) & 31u))));
let _e1671 = local_26.member[2u];
let _e1672 = (_e1638 + _e1671);
let _e1674 = (_e1672 >> bitcast<u32>(1i));
let _e1677 = bitcast<u32>(((_e1672 & 1i) * 16i));
let _e1679 = select(_e1425, _e1674, (_e1674 < _e1425));
let _e1684 = global_2.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1688 = (_e1674 + 1i);
let _e1690 = select(_e1425, _e1688, (_e1688 < _e1425));
let _e1695 = global_2.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1702 = ((_e1684 >> bitcast<u32>((_e1677 & 31u))) | ((_e1695 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1677) & 31u))));
let _e1703 = local_26.member_1[0u];
let _e1709 = f32(bitcast<i32>(((_e1670 >> bitcast<u32>((_e1703 & 31u))) & 65535u)));
let _e1710 = local_26.member_1[1u];
let _e1716 = f32(bitcast<i32>(((_e1670 >> bitcast<u32>((_e1710 & 31u))) & 65535u)));
let _e1717 = local_26.member_1[4u];
let _e1723 = f32(bitcast<i32>(((_e1702 >> bitcast<u32>((_e1717 & 31u))) & 65535u)));
let _e1724 = local_26.member_1[5u];
let _e1731 = local_27[0u];
let _e1734 = (_e1709 + ((_e1716 - _e1709) * _e1731));
let _e1735 = local_27[0u];
let _e1738 = (_e1716 + ((_e1723 - _e1716) * _e1735));
let _e1739 = local_27[0u];
let _e1742 = (_e1723 + ((f32(bitcast<i32>(((_e1702 >> bitcast<u32>((_e1724 & 31u))) & 65535u))) - _e1723) * _e1739));
let _e1743 = (_e1401 + _e1397);
let _e1744 = local_26.member[0u];
let _e1745 = (_e1743 + _e1744);
let _e1747 = (_e1745 >> bitcast<u32>(1i));
let _e1750 = bitcast<u32>(((_e1745 & 1i) * 16i));
let _e1752 = select(_e1425, _e1747, (_e1747 < _e1425));
let _e1757 = global_2.member[bitcast<u32>(select(0i, _e1752, (_e1752 > 0i)))];
let _e1761 = (_e1747 + 1i);
let _e1763 = select(_e1425, _e1761, (_e1761 < _e1425));
let _e1768 = global_2.member[bitcast<u32>(select(0i, _e1763, (_e1763 > 0i)))];
let _e1775 = ((_e1757 >> bitcast<u32>((_e1750 & 31u))) | ((_e1768 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1750) & 31u))));
let _e1776 = local_26.member[2u];
let _e1777 = (_e1743 + _e1776);
let _e1779 = (_e1777 >> bitcast<u32>(1i));
let _e1782 = bitcast<u32>(((_e1777 & 1i) * 16i));
let _e1784 = select(_e1425, _e1779, (_e1779 < _e1425));
let _e1789 = global_2.member[bitcast<u32>(select(0i, _e1784, (_e1784 > 0i)))];
let _e1793 = (_e1779 + 1i);
let _e1795 = select(_e1425, _e1793, (_e1793 < _e1425));
let _e1800 = global_2.member[bitcast<u32>(select(0i, _e1795, (_e1795 > 0i)))];
let _e1807 = ((_e1789 >> bitcast<u32>((_e1782 & 31u))) | ((_e1800 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1782) & 31u))));
let _e1808 = local_26.member_1[0u];
let _e1814 = f32(bitcast<i32>(((_e1775 >> bitcast<u32>((_e1808 & 31u))) & 65535u)));
let _e1815 = local_26.member_1[1u];
let _e1821 = f32(bitcast<i32>(((_e1775 >> bitcast<u32>((_e1815 & 31u))) & 65535u)));
let _e1822 = local_26.member_1[4u];
let _e1828 = f32(bitcast<i32>(((_e1807 >> bitcast<u32>((_e1822 & 31u))) & 65535u)));
let _e1829 = local_26.member_1[5u];
let _e1836 = local_27[0u];
let _e1840 = local_27[0u];
let _e1843 = (_e1821 + ((_e1828 - _e1821) * _e1840));
let _e1844 = local_27[0u];
let _e1851 = local_26.member[1u];
let _e1852 = ((_e1400 + _e1395) + _e1851);
let _e1854 = (_e1852 >> bitcast<u32>(1i));
let _e1857 = bitcast<u32>(((_e1852 & 1i) * 16i));
let _e1859 = select(_e1425, _e1854, (_e1854 < _e1425));
let _e1864 = global_2.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1868 = (_e1854 + 1i);
let _e1870 = select(_e1425, _e1868, (_e1868 < _e1425));
let _e1875 = global_2.member[bitcast<u32>(select(0i, _e1870, (_e1870 > 0i)))];
let _e1882 = ((_e1864 >> bitcast<u32>((_e1857 & 31u))) | ((_e1875 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1857) & 31u))));
let _e1885 = local_26.member_1[2u];
let _e1891 = f32(bitcast<i32>(((_e1882 >> bitcast<u32>((_e1885 & 31u))) & 65535u)));
let _e1894 = local_26.member_1[3u];
let _e1901 = local_27[0u];
let _e1904 = (_e1891 + ((f32(bitcast<i32>(((_e1882 >> bitcast<u32>((_e1894 & 31u))) & 65535u))) - _e1891) * _e1901));
let _e1906 = local_26.member[1u];
let _e1907 = ((_e1400 + _e1398) + _e1906);
let _e1909 = (_e1907 >> bitcast<u32>(1i));
let _e1912 = bitcast<u32>(((_e1907 & 1i) * 16i));
let _e1914 = select(_e1425, _e1909, (_e1909 < _e1425));
let _e1919 = global_2.member[bitcast<u32>(select(0i, _e1914, (_e1914 > 0i)))];
let _e1923 = (_e1909 + 1i);
let _e1925 = select(_e1425, _e1923, (_e1923 < _e1425));
let _e1930 = global_2.member[bitcast<u32>(select(0i, _e1925, (_e1925 > 0i)))];
let _e1937 = ((_e1919 >> bitcast<u32>((_e1912 & 31u))) | ((_e1930 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1912) & 31u))));
let _e1938 = local_26.member_1[2u];
let _e1944 = f32(bitcast<i32>(((_e1937 >> bitcast<u32>((_e1938 & 31u))) & 65535u)));
let _e1945 = local_26.member_1[3u];
let _e1952 = local_27[0u];
let _e1957 = local_26.member[1u];
let _e1958 = ((_e1401 + _e1395) + _e1957);
let _e1960 = (_e1958 >> bitcast<u32>(1i));
let _e1963 = bitcast<u32>(((_e1958 & 1i) * 16i));
let _e1965 = select(_e1425, _e1960, (_e1960 < _e1425));
let _e1970 = global_2.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1974 = (_e1960 + 1i);
let _e1976 = select(_e1425, _e1974, (_e1974 < _e1425));
let _e1981 = global_2.member[bitcast<u32>(select(0i, _e1976, (_e1976 > 0i)))];
let _e1988 = ((_e1970 >> bitcast<u32>((_e1963 & 31u))) | ((_e1981 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1963) & 31u))));
let _e1989 = local_26.member_1[2u];
let _e1995 = f32(bitcast<i32>(((_e1988 >> bitcast<u32>((_e1989 & 31u))) & 65535u)));
let _e1996 = local_26.member_1[3u];
let _e2003 = local_27[0u];
let _e2006 = (_e1995 + ((f32(bitcast<i32>(((_e1988 >> bitcast<u32>((_e1996 & 31u))) & 65535u))) - _e1995) * _e2003));
let _e2008 = local_26.member[1u];
let _e2009 = ((_e1401 + _e1398) + _e2008);
let _e2011 = (_e2009 >> bitcast<u32>(1i));
let _e2014 = bitcast<u32>(((_e2009 & 1i) * 16i));
let _e2016 = select(_e1425, _e2011, (_e2011 < _e1425));
let _e2021 = global_2.member[bitcast<u32>(select(0i, _e2016, (_e2016 > 0i)))];
let _e2025 = (_e2011 + 1i);
let _e2027 = select(_e1425, _e2025, (_e2025 < _e1425));
let _e2032 = global_2.member[bitcast<u32>(select(0i, _e2027, (_e2027 > 0i)))];
let _e2039 = ((_e2021 >> bitcast<u32>((_e2014 & 31u))) | ((_e2032 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2014) & 31u))));
let _e2040 = local_26.member_1[2u];
let _e2046 = f32(bitcast<i32>(((_e2039 >> bitcast<u32>((_e2040 & 31u))) & 65535u)));
let _e2047 = local_26.member_1[3u];
let _e2054 = local_27[0u];
let _e2059 = local_26.member[1u];
let _e2060 = ((_e1399 + _e1396) + _e2059);
let _e2062 = (_e2060 >> bitcast<u32>(1i));
let _e2065 = bitcast<u32>(((_e2060 & 1i) * 16i));
let _e2067 = select(_e1425, _e2062, (_e2062 < _e1425));
let _e2072 = global_2.member[bitcast<u32>(select(0i, _e2067, (_e2067 > 0i)))];
let _e2076 = (_e2062 + 1i);
let _e2078 = select(_e1425, _e2076, (_e2076 < _e1425));
let _e2083 = global_2.member[bitcast<u32>(select(0i, _e2078, (_e2078 > 0i)))];
let _e2090 = ((_e2072 >> bitcast<u32>((_e2065 & 31u))) | ((_e2083 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2065) & 31u))));
let _e2091 = local_26.member_1[2u];
let _e2097 = f32(bitcast<i32>(((_e2090 >> bitcast<u32>((_e2091 & 31u))) & 65535u)));
let _e2098 = local_26.member_1[3u];
let _e2105 = local_27[0u];
let _e2108 = (_e2097 + ((f32(bitcast<i32>(((_e2090 >> bitcast<u32>((_e2098 & 31u))) & 65535u))) - _e2097) * _e2105));
let _e2110 = local_26.member[1u];
let _e2111 = ((_e1402 + _e1396) + _e2110);
let _e2113 = (_e2111 >> bitcast<u32>(1i));
let _e2116 = bitcast<u32>(((_e2111 & 1i) * 16i));
let _e2118 = select(_e1425, _e2113, (_e2113 < _e1425));
let _e2123 = global_2.member[bitcast<u32>(select(0i, _e2118, (_e2118 > 0i)))];
let _e2127 = (_e2113 + 1i);
let _e2129 = select(_e1425, _e2127, (_e2127 < _e1425));
let _e2134 = global_2.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2141 = ((_e2123 >> bitcast<u32>((_e2116 & 31u))) | ((_e2134 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2116) & 31u))));
let _e2142 = local_26.member_1[2u];
let _e2148 = f32(bitcast<i32>(((_e2141 >> bitcast<u32>((_e2142 & 31u))) & 65535u)));
let _e2149 = local_26.member_1[3u];
let _e2156 = local_27[0u];
let _e2159 = (_e2148 + ((f32(bitcast<i32>(((_e2141 >> bitcast<u32>((_e2149 & 31u))) & 65535u))) - _e2148) * _e2156));
let _e2161 = local_26.member[1u];
let _e2162 = ((_e1399 + _e1397) + _e2161);
let _e2164 = (_e2162 >> bitcast<u32>(1i));
let _e2167 = bitcast<u32>(((_e2162 & 1i) * 16i));
let _e2169 = select(_e1425, _e2164, (_e2164 < _e1425));
let _e2174 = global_2.member[bitcast<u32>(select(0i, _e2169, (_e2169 > 0i)))];
let _e2178 = (_e2164 + 1i);
let _e2180 = select(_e1425, _e2178, (_e2178 < _e1425));
let _e2185 = global_2.member[bitcast<u32>(select(0i, _e2180, (_e2180 > 0i)))];
let _e2192 = ((_e2174 >> bitcast<u32>((_e2167 & 31u))) | ((_e2185 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2167) & 31u))));
let _e2193 = local_26.member_1[2u];
let _e2199 = f32(bitcast<i32>(((_e2192 >> bitcast<u32>((_e2193 & 31u))) & 65535u)));
let _e2200 = local_26.member_1[3u];
let _e2207 = local_27[0u];
let _e2212 = local_26.member[1u];
let _e2213 = ((_e1402 + _e1397) + _e2212);
let _e2215 = (_e2213 >> bitcast<u32>(1i));
let _e2218 = bitcast<u32>(((_e2213 & 1i) * 16i));
let _e2220 = select(_e1425, _e2215, (_e2215 < _e1425));
let _e2225 = global_2.member[bitcast<u32>(select(0i, _e2220, (_e2220 > 0i)))];
let _e2229 = (_e2215 + 1i);
let _e2231 = select(_e1425, _e2229, (_e2229 < _e1425));
let _e2236 = global_2.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2243 = ((_e2225 >> bitcast<u32>((_e2218 & 31u))) | ((_e2236 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2218) & 31u))));
let _e2244 = local_26.member_1[2u];
let _e2250 = f32(bitcast<i32>(((_e2243 >> bitcast<u32>((_e2244 & 31u))) & 65535u)));
let _e2251 = local_26.member_1[3u];
let _e2258 = local_27[0u];
let _e2263 = local_27[1u];
let _e2266 = (_e1528 + ((_e1633 - _e1528) * _e2263));
let _e2267 = local_27[1u];
let _e2270 = (_e1738 + ((_e1843 - _e1738) * _e2267));
let _e2271 = local_27[1u];
let _e2274 = (_e1524 + (((_e1604 + ((_e1611 - _e1604) * _e1626)) - _e1524) * _e2271));
let _e2275 = local_27[1u];
let _e2280 = local_27[2u];
let _e2284 = local_27[1u];
let _e2287 = (_e1532 + (((_e1618 + ((f32(bitcast<i32>(((_e1597 >> bitcast<u32>((_e1619 & 31u))) & 65535u))) - _e1618) * _e1634)) - _e1532) * _e2284));
let _e2288 = local_27[1u];
let _e2292 = local_27[2u];
let _e2296 = local_27[1u];
let _e2299 = (_e1904 + ((_e1528 - _e1904) * _e2296));
let _e2300 = local_27[1u];
let _e2304 = local_27[2u];
let _e2308 = local_27[1u];
let _e2311 = (_e1633 + (((_e1944 + ((f32(bitcast<i32>(((_e1937 >> bitcast<u32>((_e1945 & 31u))) & 65535u))) - _e1944) * _e1952)) - _e1633) * _e2308));
let _e2312 = local_27[1u];
let _e2316 = local_27[2u];
let _e2320 = local_27[1u];
let _e2323 = (_e2108 + (((_e2199 + ((f32(bitcast<i32>(((_e2192 >> bitcast<u32>((_e2200 & 31u))) & 65535u))) - _e2199) * _e2207)) - _e2108) * _e2320));
let _e2324 = local_27[2u];
let _e2328 = local_27[1u];
let _e2332 = local_27[2u];
let _e2336 = local_27[2u];
let _e2343 = global_1.member.member_8.member_6;
let _e2347 = global_1.member.member_8.member_5;
let _e2349 = (((_e2266 + ((_e2270 - _e2266) * _e2336)) - _e2343) * _e2347);
let _e2350 = -(1e9f);
let _e2352 = select(_e2350, _e2349, (_e2349 > _e2350));
let _e2354 = select(1e9f, _e2352, (_e2352 < 1e9f));
let _e2356 = (((_e2274 + (((_e1734 + (((_e1814 + ((_e1821 - _e1814) * _e1836)) - _e1734) * _e2275)) - _e2274) * _e2280)) - _e2343) * _e2347);
let _e2358 = select(_e2350, _e2356, (_e2356 > _e2350));
let _e2360 = select(1e9f, _e2358, (_e2358 < 1e9f));
let _e2362 = (((_e2287 + (((_e1742 + (((_e1828 + ((f32(bitcast<i32>(((_e1807 >> bitcast<u32>((_e1829 & 31u))) & 65535u))) - _e1828) * _e1844)) - _e1742) * _e2288)) - _e2287) * _e2292)) - _e2343) * _e2347);
let _e2364 = select(_e2350, _e2362, (_e2362 > _e2350));
let _e2366 = select(1e9f, _e2364, (_e2364 < 1e9f));
let _e2368 = (((_e2299 + (((_e2006 + ((_e1738 - _e2006) * _e2300)) - _e2299) * _e2304)) - _e2343) * _e2347);
let _e2370 = select(_e2350, _e2368, (_e2368 > _e2350));
let _e2372 = select(1e9f, _e2370, (_e2370 < 1e9f));
let _e2374 = (((_e2311 + (((_e1843 + (((_e2046 + ((f32(bitcast<i32>(((_e2039 >> bitcast<u32>((_e2047 & 31u))) & 65535u))) - _e2046) * _e2054)) - _e1843) * _e2312)) - _e2311) * _e2316)) - _e2343) * _e2347);
let _e2376 = select(_e2350, _e2374, (_e2374 > _e2350));
let _e2378 = select(1e9f, _e2376, (_e2376 < 1e9f));
let _e2380 = (((_e2323 + ((_e2266 - _e2323) * _e2324)) - _e2343) * _e2347);
let _e2382 = select(_e2350, _e2380, (_e2380 > _e2350));
let _e2384 = select(1e9f, _e2382, (_e2382 < 1e9f));
let _e2386 = (((_e2270 + (((_e2159 + (((_e2250 + ((f32(bitcast<i32>(((_e2243 >> bitcast<u32>((_e2251 & 31u))) & 65535u))) - _e2250) * _e2258)) - _e2159) * _e2328)) - _e2270) * _e2332)) - _e2343) * _e2347);
let _e2388 = select(_e2350, _e2386, (_e2386 > _e2350));
let _e2390 = select(1e9f, _e2388, (_e2388 < 1e9f));
local_24 = _e2354;
let _e2391 = local_24;
local_25 = _e2391;
let _e2392 = local_25;
let _e2394 = (bitcast<i32>(_e163) - 1i);
let _e2396 = select(_e2394, 263197i, (263197i < _e2394));
let _e2401 = global_3.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2402 = bitcast<f32>(_e2401);
let _e2404 = select(_e2394, 263198i, (263198i < _e2394));
let _e2407 = bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)));
let _e2409 = global_3.member[_e2407];
let _e2410 = bitcast<f32>(_e2409);
let _e2412 = select(_e2394, 263199i, (263199i < _e2394));
let _e2417 = global_3.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2418 = bitcast<f32>(_e2417);
let _e2420 = ((_e2392 - _e2402) * _e2410);
let _e2422 = select(0f, _e2420, (_e2420 > 0f));
let _e2425 = local_25;
let _e2427 = select(_e2394, 263200i, (263200i < _e2394));
let _e2432 = global_3.member[bitcast<u32>(select(0i, _e2427, (_e2427 > 0i)))];
let _e2433 = bitcast<f32>(_e2432);
let _e2435 = select(_e2394, 263201i, (263201i < _e2394));
let _e2440 = global_3.member[bitcast<u32>(select(0i, _e2435, (_e2435 > 0i)))];
let _e2441 = bitcast<f32>(_e2440);
let _e2443 = select(_e2394, 263202i, (263202i < _e2394));
let _e2448 = global_3.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2449 = bitcast<f32>(_e2448);
let _e2451 = ((_e2425 - _e2433) * _e2441);
let _e2453 = select(0f, _e2451, (_e2451 > 0f));
let _e2457 = local_25;
let _e2459 = select(_e2394, 263203i, (263203i < _e2394));
let _e2464 = global_3.member[bitcast<u32>(select(0i, _e2459, (_e2459 > 0i)))];
let _e2465 = bitcast<f32>(_e2464);
let _e2467 = select(_e2394, 263204i, (263204i < _e2394));
let _e2472 = global_3.member[bitcast<u32>(select(0i, _e2467, (_e2467 > 0i)))];
let _e2473 = bitcast<f32>(_e2472);
let _e2475 = select(_e2394, 263205i, (263205i < _e2394));
let _e2480 = global_3.member[bitcast<u32>(select(0i, _e2475, (_e2475 > 0i)))];
let _e2481 = bitcast<f32>(_e2480);
let _e2483 = ((_e2457 - _e2465) * _e2473);
let _e2485 = select(0f, _e2483, (_e2483 > 0f));
let _e2488 = local_25;
let _e2490 = select(_e2394, 263206i, (263206i < _e2394));
let _e2495 = global_3.member[bitcast<u32>(select(0i, _e2490, (_e2490 > 0i)))];
let _e2496 = bitcast<f32>(_e2495);
let _e2498 = select(_e2394, 263207i, (263207i < _e2394));
let _e2503 = global_3.member[bitcast<u32>(select(0i, _e2498, (_e2498 > 0i)))];
let _e2504 = bitcast<f32>(_e2503);
let _e2506 = select(_e2394, 263208i, (263208i < _e2394));
let _e2511 = global_3.member[bitcast<u32>(select(0i, _e2506, (_e2506 > 0i)))];
let _e2512 = bitcast<f32>(_e2511);
let _e2514 = ((_e2488 - _e2496) * _e2504);
let _e2516 = select(0f, _e2514, (_e2514 > 0f));
let _e2520 = ((select(_e2418, _e2422, (_e2422 < _e2418)) + select(_e2449, _e2453, (_e2453 < _e2449))) + (select(_e2481, _e2485, (_e2485 < _e2481)) + select(_e2512, _e2516, (_e2516 < _e2512))));
let _e2522 = select(0f, _e2520, (_e2520 > 0f));
let _e2524 = select(1023f, _e2522, (_e2522 < 1023f));
let _e2531 = select(0i, select(select(i32(_e2524), i32(-2147483648), (_e2524 < -2147483600f)), 2147483647i, (_e2524 > 2147483500f)), (_e2524 == _e2524));
let _e2535 = (_e2531 - select(0i, 1i, (_e2524 < f32(_e2531))));
let _e2536 = (262147i + _e2535);
let _e2538 = select(_e2394, _e2536, (_e2536 < _e2394));
let _e2544 = global_3.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2554 = select(_e2394, 262146i, (262146i < _e2394));
let _e2560 = global_3.member[bitcast<u32>(select(0i, _e2554, (_e2554 > 0i)))];
let _e2561 = bitcast<f32>(_e2560);
let _e2562 = (f32((bitcast<i32>((_e2544 & 4095u)) - 2048i)) * _e2561);
let _e2564 = select(_e2394, 262144i, (262144i < _e2394));
let _e2570 = global_3.member[bitcast<u32>(select(0i, _e2564, (_e2564 > 0i)))];
let _e2571 = bitcast<f32>(_e2570);
let _e2573 = select(_e2394, 262145i, (262145i < _e2394));
let _e2579 = global_3.member[bitcast<u32>(select(0i, _e2573, (_e2573 > 0i)))];
let _e2580 = bitcast<f32>(_e2579);
let _e2586 = ((_e2571 + (f32(bitcast<i32>((_e2544 >> bitcast<u32>(12u)))) * _e2580)) + (_e2562 * (_e2520 - f32(_e2535))));
let _e2589 = global_3.member[_e2407];
let _e2591 = local_24;
let _e2594 = local_24;
let _e2597 = local_24;
let _e2601 = select(_e2394, 263209i, (263209i < _e2394));
let _e2607 = global_3.member[bitcast<u32>(select(0i, _e2601, (_e2601 > 0i)))];
let _e2609 = local_24;
let _e2612 = select(_e2394, 263210i, (263210i < _e2394));
let _e2618 = global_3.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2620 = local_24;
let _e2624 = (_e2562 * select(0f, select(select(select(bitcast<f32>(_e2589), _e2441, (_e2591 >= _e2433)), _e2473, (_e2594 >= _e2465)), _e2504, (_e2597 >= _e2496)), ((_e2609 >= bitcast<f32>(_e2607)) && (_e2620 <= bitcast<f32>(_e2618)))));
if _e1226 {
let _e2631 = ((0.5f * (_e2366 - _e2360)) * _e2624);
let _e2632 = ((0.5f * (_e2378 - _e2372)) * _e2624);
let _e2633 = ((0.5f * (_e2390 - _e2384)) * _e2624);
phi_7460_ = type_32(_e2586, vec3<f32>(_e2631, _e2632, _e2633), vec3<f32>((_e2631 * _e2586), (_e2632 * _e2586), (_e2633 * _e2586)));
} else {
local_22 = _e2360;
let _e2640 = local_22;
local_23 = _e2640;
let _e2641 = local_23;
let _e2643 = ((_e2641 - _e2402) * _e2410);
let _e2645 = select(0f, _e2643, (_e2643 > 0f));
let _e2648 = local_23;
let _e2650 = ((_e2648 - _e2433) * _e2441);
let _e2652 = select(0f, _e2650, (_e2650 > 0f));
let _e2656 = local_23;
let _e2658 = ((_e2656 - _e2465) * _e2473);
let _e2660 = select(0f, _e2658, (_e2658 > 0f));
let _e2663 = local_23;
let _e2665 = ((_e2663 - _e2496) * _e2504);
let _e2667 = select(0f, _e2665, (_e2665 > 0f));
let _e2671 = ((select(_e2418, _e2645, (_e2645 < _e2418)) + select(_e2449, _e2652, (_e2652 < _e2449))) + (select(_e2481, _e2660, (_e2660 < _e2481)) + select(_e2512, _e2667, (_e2667 < _e2512))));
let _e2673 = select(0f, _e2671, (_e2671 > 0f));
let _e2675 = select(1023f, _e2673, (_e2673 < 1023f));
let _e2682 = select(0i, select(select(i32(_e2675), i32(-2147483648), (_e2675 < -2147483600f)), 2147483647i, (_e2675 > 2147483500f)), (_e2675 == _e2675));
let _e2686 = (_e2682 - select(0i, 1i, (_e2675 < f32(_e2682))));
let _e2687 = (262147i + _e2686);
let _e2689 = select(_e2394, _e2687, (_e2687 < _e2394));
let _e2695 = global_3.member[bitcast<u32>(select(0i, _e2689, (_e2689 > 0i)))];
let _e2710 = ((_e2571 + (f32(bitcast<i32>((_e2695 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e2695 & 4095u)) - 2048i)) * _e2561) * (_e2671 - f32(_e2686))));
local_20 = _e2366;
let _e2711 = local_20;
local_21 = _e2711;
let _e2712 = local_21;
let _e2714 = ((_e2712 - _e2402) * _e2410);
let _e2716 = select(0f, _e2714, (_e2714 > 0f));
let _e2719 = local_21;
let _e2721 = ((_e2719 - _e2433) * _e2441);
let _e2723 = select(0f, _e2721, (_e2721 > 0f));
let _e2727 = local_21;
let _e2729 = ((_e2727 - _e2465) * _e2473);
let _e2731 = select(0f, _e2729, (_e2729 > 0f));
let _e2734 = local_21;
let _e2736 = ((_e2734 - _e2496) * _e2504);
let _e2738 = select(0f, _e2736, (_e2736 > 0f));
let _e2742 = ((select(_e2418, _e2716, (_e2716 < _e2418)) + select(_e2449, _e2723, (_e2723 < _e2449))) + (select(_e2481, _e2731, (_e2731 < _e2481)) + select(_e2512, _e2738, (_e2738 < _e2512))));
let _e2744 = select(0f, _e2742, (_e2742 > 0f));
let _e2746 = select(1023f, _e2744, (_e2744 < 1023f));
let _e2753 = select(0i, select(select(i32(_e2746), i32(-2147483648), (_e2746 < -2147483600f)), 2147483647i, (_e2746 > 2147483500f)), (_e2746 == _e2746));
let _e2757 = (_e2753 - select(0i, 1i, (_e2746 < f32(_e2753))));
let _e2758 = (262147i + _e2757);
let _e2760 = select(_e2394, _e2758, (_e2758 < _e2394));
let _e2766 = global_3.member[bitcast<u32>(select(0i, _e2760, (_e2760 > 0i)))];
let _e2781 = ((_e2571 + (f32(bitcast<i32>((_e2766 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e2766 & 4095u)) - 2048i)) * _e2561) * (_e2742 - f32(_e2757))));
local_18 = _e2372;
let _e2782 = local_18;
local_19 = _e2782;
let _e2783 = local_19;
let _e2785 = ((_e2783 - _e2402) * _e2410);
let _e2787 = select(0f, _e2785, (_e2785 > 0f));
let _e2790 = local_19;
let _e2792 = ((_e2790 - _e2433) * _e2441);
let _e2794 = select(0f, _e2792, (_e2792 > 0f));
let _e2798 = local_19;
let _e2800 = ((_e2798 - _e2465) * _e2473);
let _e2802 = select(0f, _e2800, (_e2800 > 0f));
let _e2805 = local_19;
let _e2807 = ((_e2805 - _e2496) * _e2504);
let _e2809 = select(0f, _e2807, (_e2807 > 0f));
let _e2813 = ((select(_e2418, _e2787, (_e2787 < _e2418)) + select(_e2449, _e2794, (_e2794 < _e2449))) + (select(_e2481, _e2802, (_e2802 < _e2481)) + select(_e2512, _e2809, (_e2809 < _e2512))));
let _e2815 = select(0f, _e2813, (_e2813 > 0f));
let _e2817 = select(1023f, _e2815, (_e2815 < 1023f));
let _e2824 = select(0i, select(select(i32(_e2817), i32(-2147483648), (_e2817 < -2147483600f)), 2147483647i, (_e2817 > 2147483500f)), (_e2817 == _e2817));
let _e2828 = (_e2824 - select(0i, 1i, (_e2817 < f32(_e2824))));
let _e2829 = (262147i + _e2828);
let _e2831 = select(_e2394, _e2829, (_e2829 < _e2394));
let _e2837 = global_3.member[bitcast<u32>(select(0i, _e2831, (_e2831 > 0i)))];
let _e2852 = ((_e2571 + (f32(bitcast<i32>((_e2837 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e2837 & 4095u)) - 2048i)) * _e2561) * (_e2813 - f32(_e2828))));
local_16 = _e2378;
let _e2853 = local_16;
local_17 = _e2853;
let _e2854 = local_17;
let _e2856 = ((_e2854 - _e2402) * _e2410);
let _e2858 = select(0f, _e2856, (_e2856 > 0f));
let _e2861 = local_17;
let _e2863 = ((_e2861 - _e2433) * _e2441);
let _e2865 = select(0f, _e2863, (_e2863 > 0f));
let _e2869 = local_17;
let _e2871 = ((_e2869 - _e2465) * _e2473);
let _e2873 = select(0f, _e2871, (_e2871 > 0f));
let _e2876 = local_17;
let _e2878 = ((_e2876 - _e2496) * _e2504);
let _e2880 = select(0f, _e2878, (_e2878 > 0f));
let _e2884 = ((select(_e2418, _e2858, (_e2858 < _e2418)) + select(_e2449, _e2865, (_e2865 < _e2449))) + (select(_e2481, _e2873, (_e2873 < _e2481)) + select(_e2512, _e2880, (_e2880 < _e2512))));
let _e2886 = select(0f, _e2884, (_e2884 > 0f));
let _e2888 = select(1023f, _e2886, (_e2886 < 1023f));
let _e2895 = select(0i, select(select(i32(_e2888), i32(-2147483648), (_e2888 < -2147483600f)), 2147483647i, (_e2888 > 2147483500f)), (_e2888 == _e2888));
let _e2899 = (_e2895 - select(0i, 1i, (_e2888 < f32(_e2895))));
let _e2900 = (262147i + _e2899);
let _e2902 = select(_e2394, _e2900, (_e2900 < _e2394));
let _e2908 = global_3.member[bitcast<u32>(select(0i, _e2902, (_e2902 > 0i)))];
let _e2923 = ((_e2571 + (f32(bitcast<i32>((_e2908 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e2908 & 4095u)) - 2048i)) * _e2561) * (_e2884 - f32(_e2899))));
local_14 = _e2384;
let _e2924 = local_14;
local_15 = _e2924;
let _e2925 = local_15;
let _e2927 = ((_e2925 - _e2402) * _e2410);
let _e2929 = select(0f, _e2927, (_e2927 > 0f));
let _e2932 = local_15;
let _e2934 = ((_e2932 - _e2433) * _e2441);
let _e2936 = select(0f, _e2934, (_e2934 > 0f));
let _e2940 = local_15;
let _e2942 = ((_e2940 - _e2465) * _e2473);
let _e2944 = select(0f, _e2942, (_e2942 > 0f));
let _e2947 = local_15;
let _e2949 = ((_e2947 - _e2496) * _e2504);
let _e2951 = select(0f, _e2949, (_e2949 > 0f));
let _e2955 = ((select(_e2418, _e2929, (_e2929 < _e2418)) + select(_e2449, _e2936, (_e2936 < _e2449))) + (select(_e2481, _e2944, (_e2944 < _e2481)) + select(_e2512, _e2951, (_e2951 < _e2512))));
let _e2957 = select(0f, _e2955, (_e2955 > 0f));
let _e2959 = select(1023f, _e2957, (_e2957 < 1023f));
let _e2966 = select(0i, select(select(i32(_e2959), i32(-2147483648), (_e2959 < -2147483600f)), 2147483647i, (_e2959 > 2147483500f)), (_e2959 == _e2959));
let _e2970 = (_e2966 - select(0i, 1i, (_e2959 < f32(_e2966))));
let _e2971 = (262147i + _e2970);
let _e2973 = select(_e2394, _e2971, (_e2971 < _e2394));
let _e2979 = global_3.member[bitcast<u32>(select(0i, _e2973, (_e2973 > 0i)))];
let _e2994 = ((_e2571 + (f32(bitcast<i32>((_e2979 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e2979 & 4095u)) - 2048i)) * _e2561) * (_e2955 - f32(_e2970))));
local_12 = _e2390;
let _e2995 = local_12;
local_13 = _e2995;
let _e2996 = local_13;
let _e2998 = ((_e2996 - _e2402) * _e2410);
let _e3000 = select(0f, _e2998, (_e2998 > 0f));
let _e3003 = local_13;
let _e3005 = ((_e3003 - _e2433) * _e2441);
let _e3007 = select(0f, _e3005, (_e3005 > 0f));
let _e3011 = local_13;
let _e3013 = ((_e3011 - _e2465) * _e2473);
let _e3015 = select(0f, _e3013, (_e3013 > 0f));
let _e3018 = local_13;
let _e3020 = ((_e3018 - _e2496) * _e2504);
let _e3022 = select(0f, _e3020, (_e3020 > 0f));
let _e3026 = ((select(_e2418, _e3000, (_e3000 < _e2418)) + select(_e2449, _e3007, (_e3007 < _e2449))) + (select(_e2481, _e3015, (_e3015 < _e2481)) + select(_e2512, _e3022, (_e3022 < _e2512))));
let _e3028 = select(0f, _e3026, (_e3026 > 0f));
let _e3030 = select(1023f, _e3028, (_e3028 < 1023f));
let _e3037 = select(0i, select(select(i32(_e3030), i32(-2147483648), (_e3030 < -2147483600f)), 2147483647i, (_e3030 > 2147483500f)), (_e3030 == _e3030));
let _e3041 = (_e3037 - select(0i, 1i, (_e3030 < f32(_e3037))));
let _e3042 = (262147i + _e3041);
let _e3044 = select(_e2394, _e3042, (_e3042 < _e2394));
let _e3050 = global_3.member[bitcast<u32>(select(0i, _e3044, (_e3044 > 0i)))];
let _e3065 = ((_e2571 + (f32(bitcast<i32>((_e3050 >> bitcast<u32>(12u)))) * _e2580)) + ((f32((bitcast<i32>((_e3050 & 4095u)) - 2048i)) * _e2561) * (_e3026 - f32(_e3041))));
let _e3066 = (_e2781 - _e2710);
let _e3068 = (_e2923 - _e2852);
let _e3070 = (_e3065 - _e2994);
phi_7460_ = type_32(_e2586, vec3<f32>((0.5f * _e3066), (0.5f * _e3068), (0.5f * _e3070)), vec3<f32>((0.25f * (_e3066 * (_e2781 + _e2710))), (0.25f * (_e3068 * (_e2923 + _e2852))), (0.25f * (_e3070 * (_e3065 + _e2994)))));
}
let _e3085 = phi_7460_;
let _e3100 = select(0f, 1f, ((((((_e1206 >= -0.5f) && (_e1206 <= _e1233)) && (_e1212 >= -0.5f)) && (_e1212 <= _e1243)) && (_e1218 >= -0.5f)) && (_e1218 <= _e1253)));
let _e3102 = (0.5f * (_e2366 - _e2360));
let _e3104 = (0.5f * (_e2378 - _e2372));
let _e3106 = (0.5f * (_e2390 - _e2384));
let _e3112 = global_1.member.member_8.member.member.member;
let _e3118 = global_1.member.member_8.member.member.member_1;
let _e3124 = global_1.member.member_8.member.member.member_2;
let _e3130 = global_1.member.member_8.member_1.member.member;
let _e3136 = global_1.member.member_8.member_1.member.member_1;
let _e3142 = global_1.member.member_8.member_1.member.member_2;
let _e3148 = global_1.member.member_8.member_2.member.member;
let _e3154 = global_1.member.member_8.member_2.member.member_1;
let _e3160 = global_1.member.member_8.member_2.member.member_2;
phi_8239_ = type_33(_e2354, vec3<f32>(((((_e3112 * _e3102) + (_e3130 * _e3104)) + (_e3148 * _e3106)) * _e3100), ((((_e3118 * _e3102) + (_e3136 * _e3104)) + (_e3154 * _e3106)) * _e3100), ((((_e3124 * _e3102) + (_e3142 * _e3104)) + (_e3160 * _e3106)) * _e3100)), _e3085.member, vec3<f32>(((((_e3112 * _e3085.member_2.x) + (_e3130 * _e3085.member_2.y)) + (_e3148 * _e3085.member_2.z)) * _e3100), ((((_e3118 * _e3085.member_2.x) + (_e3136 * _e3085.member_2.y)) + (_e3154 * _e3085.member_2.z)) * _e3100), ((((_e3124 * _e3085.member_2.x) + (_e3142 * _e3085.member_2.y)) + (_e3160 * _e3085.member_2.z)) * _e3100)), vec3<f32>(((((_e3112 * _e3085.member_1.x) + (_e3130 * _e3085.member_1.y)) + (_e3148 * _e3085.member_1.z)) * _e3100), ((((_e3118 * _e3085.member_1.x) + (_e3136 * _e3085.member_1.y)) + (_e3154 * _e3085.member_1.z)) * _e3100), ((((_e3124 * _e3085.member_1.x) + (_e3142 * _e3085.member_1.y)) + (_e3160 * _e3085.member_1.z)) * _e3100)));
} else {
let _e3229 = global_1.member.member_8.member_3.member;
let _e3230 = (_e3229 - 0.5f);
let _e3232 = select(-0.5f, _e1206, (_e1206 > -0.5f));
let _e3234 = select(_e3230, _e3232, (_e3232 < _e3230));
let _e3239 = global_1.member.member_8.member_3.member_1;
let _e3240 = (_e3239 - 0.5f);
let _e3242 = select(-0.5f, _e1212, (_e1212 > -0.5f));
let _e3244 = select(_e3240, _e3242, (_e3242 < _e3240));
let _e3249 = global_1.member.member_8.member_3.member_2;
let _e3250 = (_e3249 - 0.5f);
let _e3252 = select(-0.5f, _e1218, (_e1218 > -0.5f));
let _e3254 = select(_e3250, _e3252, (_e3252 < _e3250));
let _e3256 = select(-1f, _e3234, (_e3234 > -1f));
let _e3258 = select(_e3229, _e3256, (_e3256 < _e3229));
let _e3265 = select(0i, select(select(i32(_e3258), i32(-2147483648), (_e3258 < -2147483600f)), 2147483647i, (_e3258 > 2147483500f)), (_e3258 == _e3258));
let _e3269 = (_e3265 - select(0i, 1i, (_e3258 < f32(_e3265))));
let _e3271 = select(-1f, _e3244, (_e3244 > -1f));
let _e3273 = select(_e3239, _e3271, (_e3271 < _e3239));
let _e3280 = select(0i, select(select(i32(_e3273), i32(-2147483648), (_e3273 < -2147483600f)), 2147483647i, (_e3273 > 2147483500f)), (_e3273 == _e3273));
let _e3284 = (_e3280 - select(0i, 1i, (_e3273 < f32(_e3280))));
let _e3286 = select(-1f, _e3254, (_e3254 > -1f));
let _e3288 = select(_e3249, _e3286, (_e3286 < _e3249));
let _e3295 = select(0i, select(select(i32(_e3288), i32(-2147483648), (_e3288 < -2147483600f)), 2147483647i, (_e3288 > 2147483500f)), (_e3288 == _e3288));
let _e3299 = (_e3295 - select(0i, 1i, (_e3288 < f32(_e3295))));
let _e3303 = global_1.member.member_8.member_7;
let _e3307 = global_1.member.member_8.member_8;
let _e3315 = (select(0i, select(select(i32(_e3239), i32(-2147483648), (_e3239 < -2147483600f)), 2147483647i, (_e3239 > 2147483500f)), (_e3239 == _e3239)) - 1i);
let _e3318 = (_e3284 + 1i);
let _e3328 = (select(0i, select(select(i32(_e3249), i32(-2147483648), (_e3249 < -2147483600f)), 2147483647i, (_e3249 > 2147483500f)), (_e3249 == _e3249)) - 1i);
let _e3331 = (_e3299 + 1i);
let _e3340 = select(0i, select(select(i32(_e3229), i32(-2147483648), (_e3229 < -2147483600f)), 2147483647i, (_e3229 > 2147483500f)), (_e3229 == _e3229));
let _e3341 = (_e3340 - 1i);
let _e3342 = (_e3269 - 1i);
let _e3344 = select(0i, _e3342, (_e3342 > 0i));
let _e3346 = select(0i, _e3269, (_e3269 > 0i));
let _e3347 = (_e3269 + 1i);
let _e3349 = select(_e3341, _e3347, (_e3347 < _e3341));
let _e3350 = (_e3269 + 2i);
let _e3353 = (_e3340 - 2i);
let _e3355 = select(0i, _e3353, (_e3353 > 0i));
let _e3357 = select(_e3355, _e3344, (_e3344 < _e3355));
let _e3359 = select(_e3355, _e3346, (_e3346 < _e3355));
let _e3361 = select(_e3355, _e3349, (_e3349 < _e3355));
let _e3380 = (select(0i, _e3284, (_e3284 > 0i)) * _e3303);
let _e3381 = (select(_e3315, _e3318, (_e3318 < _e3315)) * _e3303);
let _e3382 = (select(0i, _e3299, (_e3299 > 0i)) * _e3307);
let _e3383 = (select(_e3328, _e3331, (_e3331 < _e3328)) * _e3307);
local_10 = type_29(array<i32, 4>(_e3357, _e3359, _e3361, 0i), array<u32, 6>(bitcast<u32>(((_e3344 - _e3357) * 16i)), bitcast<u32>(((_e3346 - _e3357) * 16i)), bitcast<u32>(((_e3346 - _e3359) * 16i)), bitcast<u32>(((_e3349 - _e3359) * 16i)), bitcast<u32>(((_e3349 - _e3361) * 16i)), bitcast<u32>(((select(_e3341, _e3350, (_e3350 < _e3341)) - _e3361) * 16i))));
local_11 = vec3<f32>((_e3234 - f32(_e3269)), (_e3244 - f32(_e3284)), (_e3254 - f32(_e3299)));
let _e3398 = local_10.member[1u];
let _e3399 = ((_e3382 + _e3380) + _e3398);
let _e3401 = (_e3399 >> bitcast<u32>(1i));
let _e3404 = bitcast<u32>(((_e3399 & 1i) * 16i));
let _e3406 = (bitcast<i32>(_e158) - 1i);
let _e3408 = select(_e3406, _e3401, (_e3401 < _e3406));
let _e3413 = global_2.member[bitcast<u32>(select(0i, _e3408, (_e3408 > 0i)))];
let _e3417 = (_e3401 + 1i);
let _e3419 = select(_e3406, _e3417, (_e3417 < _e3406));
let _e3424 = global_2.member[bitcast<u32>(select(0i, _e3419, (_e3419 > 0i)))];
let _e3431 = ((_e3413 >> bitcast<u32>((_e3404 & 31u))) | ((_e3424 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3404) & 31u))));
let _e3434 = local_10.member_1[2u];
let _e3440 = f32(bitcast<i32>(((_e3431 >> bitcast<u32>((_e3434 & 31u))) & 65535u)));
let _e3443 = local_10.member_1[3u];
let _e3450 = local_11[0u];
let _e3453 = (_e3440 + ((f32(bitcast<i32>(((_e3431 >> bitcast<u32>((_e3443 & 31u))) & 65535u))) - _e3440) * _e3450));
let _e3455 = local_10.member[1u];
let _e3456 = ((_e3382 + _e3381) + _e3455);
let _e3458 = (_e3456 >> bitcast<u32>(1i));
let _e3461 = bitcast<u32>(((_e3456 & 1i) * 16i));
let _e3463 = select(_e3406, _e3458, (_e3458 < _e3406));
let _e3468 = global_2.member[bitcast<u32>(select(0i, _e3463, (_e3463 > 0i)))];
let _e3472 = (_e3458 + 1i);
let _e3474 = select(_e3406, _e3472, (_e3472 < _e3406));
let _e3479 = global_2.member[bitcast<u32>(select(0i, _e3474, (_e3474 > 0i)))];
let _e3486 = ((_e3468 >> bitcast<u32>((_e3461 & 31u))) | ((_e3479 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3461) & 31u))));
let _e3487 = local_10.member_1[2u];
let _e3493 = f32(bitcast<i32>(((_e3486 >> bitcast<u32>((_e3487 & 31u))) & 65535u)));
let _e3494 = local_10.member_1[3u];
let _e3501 = local_11[0u];
let _e3506 = local_11[1u];
let _e3509 = (_e3453 + (((_e3493 + ((f32(bitcast<i32>(((_e3486 >> bitcast<u32>((_e3494 & 31u))) & 65535u))) - _e3493) * _e3501)) - _e3453) * _e3506));
let _e3511 = local_10.member[1u];
let _e3512 = ((_e3383 + _e3380) + _e3511);
let _e3514 = (_e3512 >> bitcast<u32>(1i));
let _e3517 = bitcast<u32>(((_e3512 & 1i) * 16i));
let _e3519 = select(_e3406, _e3514, (_e3514 < _e3406));
let _e3524 = global_2.member[bitcast<u32>(select(0i, _e3519, (_e3519 > 0i)))];
let _e3528 = (_e3514 + 1i);
let _e3530 = select(_e3406, _e3528, (_e3528 < _e3406));
let _e3535 = global_2.member[bitcast<u32>(select(0i, _e3530, (_e3530 > 0i)))];
let _e3542 = ((_e3524 >> bitcast<u32>((_e3517 & 31u))) | ((_e3535 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3517) & 31u))));
let _e3543 = local_10.member_1[2u];
let _e3549 = f32(bitcast<i32>(((_e3542 >> bitcast<u32>((_e3543 & 31u))) & 65535u)));
let _e3550 = local_10.member_1[3u];
let _e3557 = local_11[0u];
let _e3560 = (_e3549 + ((f32(bitcast<i32>(((_e3542 >> bitcast<u32>((_e3550 & 31u))) & 65535u))) - _e3549) * _e3557));
let _e3562 = local_10.member[1u];
let _e3563 = ((_e3383 + _e3381) + _e3562);
let _e3565 = (_e3563 >> bitcast<u32>(1i));
let _e3568 = bitcast<u32>(((_e3563 & 1i) * 16i));
let _e3570 = select(_e3406, _e3565, (_e3565 < _e3406));
let _e3575 = global_2.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3579 = (_e3565 + 1i);
let _e3581 = select(_e3406, _e3579, (_e3579 < _e3406));
let _e3586 = global_2.member[bitcast<u32>(select(0i, _e3581, (_e3581 > 0i)))];
let _e3593 = ((_e3575 >> bitcast<u32>((_e3568 & 31u))) | ((_e3586 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3568) & 31u))));
let _e3594 = local_10.member_1[2u];
let _e3600 = f32(bitcast<i32>(((_e3593 >> bitcast<u32>((_e3594 & 31u))) & 65535u)));
let _e3601 = local_10.member_1[3u];
let _e3608 = local_11[0u];
let _e3612 = local_11[1u];
let _e3617 = local_11[2u];
let _e3624 = global_1.member.member_8.member_6;
let _e3628 = global_1.member.member_8.member_5;
let _e3630 = (((_e3509 + (((_e3560 + (((_e3600 + ((f32(bitcast<i32>(((_e3593 >> bitcast<u32>((_e3601 & 31u))) & 65535u))) - _e3600) * _e3608)) - _e3560) * _e3612)) - _e3509) * _e3617)) - _e3624) * _e3628);
let _e3631 = -(1e9f);
let _e3633 = select(_e3631, _e3630, (_e3630 > _e3631));
phi_8239_ = type_33(select(1e9f, _e3633, (_e3633 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3638 = phi_8239_;
let _e3643 = global_1.member.member_8.member_3.member;
let _e3644 = (_e3643 - 0.5f);
let _e3646 = select(-0.5f, _e1170, (_e1170 > -0.5f));
let _e3648 = select(_e3644, _e3646, (_e3646 < _e3644));
let _e3653 = global_1.member.member_8.member_3.member_1;
let _e3654 = (_e3653 - 0.5f);
let _e3656 = select(-0.5f, _e1185, (_e1185 > -0.5f));
let _e3658 = select(_e3654, _e3656, (_e3656 < _e3654));
let _e3663 = global_1.member.member_8.member_3.member_2;
let _e3664 = (_e3663 - 0.5f);
let _e3666 = select(-0.5f, _e1200, (_e1200 > -0.5f));
let _e3668 = select(_e3664, _e3666, (_e3666 < _e3664));
let _e3670 = select(-1f, _e3648, (_e3648 > -1f));
let _e3672 = select(_e3643, _e3670, (_e3670 < _e3643));
let _e3679 = select(0i, select(select(i32(_e3672), i32(-2147483648), (_e3672 < -2147483600f)), 2147483647i, (_e3672 > 2147483500f)), (_e3672 == _e3672));
let _e3683 = (_e3679 - select(0i, 1i, (_e3672 < f32(_e3679))));
let _e3685 = select(-1f, _e3658, (_e3658 > -1f));
let _e3687 = select(_e3653, _e3685, (_e3685 < _e3653));
let _e3694 = select(0i, select(select(i32(_e3687), i32(-2147483648), (_e3687 < -2147483600f)), 2147483647i, (_e3687 > 2147483500f)), (_e3687 == _e3687));
let _e3698 = (_e3694 - select(0i, 1i, (_e3687 < f32(_e3694))));
let _e3700 = select(-1f, _e3668, (_e3668 > -1f));
let _e3702 = select(_e3663, _e3700, (_e3700 < _e3663));
let _e3709 = select(0i, select(select(i32(_e3702), i32(-2147483648), (_e3702 < -2147483600f)), 2147483647i, (_e3702 > 2147483500f)), (_e3702 == _e3702));
let _e3713 = (_e3709 - select(0i, 1i, (_e3702 < f32(_e3709))));
let _e3717 = global_1.member.member_8.member_7;
let _e3721 = global_1.member.member_8.member_8;
let _e3729 = (select(0i, select(select(i32(_e3653), i32(-2147483648), (_e3653 < -2147483600f)), 2147483647i, (_e3653 > 2147483500f)), (_e3653 == _e3653)) - 1i);
let _e3732 = (_e3698 + 1i);
let _e3742 = (select(0i, select(select(i32(_e3663), i32(-2147483648), (_e3663 < -2147483600f)), 2147483647i, (_e3663 > 2147483500f)), (_e3663 == _e3663)) - 1i);
let _e3745 = (_e3713 + 1i);
let _e3754 = select(0i, select(select(i32(_e3643), i32(-2147483648), (_e3643 < -2147483600f)), 2147483647i, (_e3643 > 2147483500f)), (_e3643 == _e3643));
let _e3755 = (_e3754 - 1i);
let _e3756 = (_e3683 - 1i);
let _e3758 = select(0i, _e3756, (_e3756 > 0i));
let _e3760 = select(0i, _e3683, (_e3683 > 0i));
let _e3761 = (_e3683 + 1i);
let _e3763 = select(_e3755, _e3761, (_e3761 < _e3755));
let _e3764 = (_e3683 + 2i);
let _e3767 = (_e3754 - 2i);
let _e3769 = select(0i, _e3767, (_e3767 > 0i));
let _e3771 = select(_e3769, _e3758, (_e3758 < _e3769));
let _e3773 = select(_e3769, _e3760, (_e3760 < _e3769));
let _e3775 = select(_e3769, _e3763, (_e3763 < _e3769));
let _e3794 = (select(0i, _e3698, (_e3698 > 0i)) * _e3717);
let _e3795 = (select(_e3729, _e3732, (_e3732 < _e3729)) * _e3717);
let _e3796 = (select(0i, _e3713, (_e3713 > 0i)) * _e3721);
let _e3797 = (select(_e3742, _e3745, (_e3745 < _e3742)) * _e3721);
local_8 = type_29(array<i32, 4>(_e3771, _e3773, _e3775, 0i), array<u32, 6>(bitcast<u32>(((_e3758 - _e3771) * 16i)), bitcast<u32>(((_e3760 - _e3771) * 16i)), bitcast<u32>(((_e3760 - _e3773) * 16i)), bitcast<u32>(((_e3763 - _e3773) * 16i)), bitcast<u32>(((_e3763 - _e3775) * 16i)), bitcast<u32>(((select(_e3755, _e3764, (_e3764 < _e3755)) - _e3775) * 16i))));
local_9 = vec3<f32>((_e3648 - f32(_e3683)), (_e3658 - f32(_e3698)), (_e3668 - f32(_e3713)));
let _e3812 = local_8.member[1u];
let _e3813 = ((_e3796 + _e3794) + _e3812);
let _e3815 = (_e3813 >> bitcast<u32>(1i));
let _e3818 = bitcast<u32>(((_e3813 & 1i) * 16i));
let _e3820 = (bitcast<i32>(_e158) - 1i);
let _e3822 = select(_e3820, _e3815, (_e3815 < _e3820));
let _e3827 = global_2.member[bitcast<u32>(select(0i, _e3822, (_e3822 > 0i)))];
let _e3831 = (_e3815 + 1i);
let _e3833 = select(_e3820, _e3831, (_e3831 < _e3820));
let _e3838 = global_2.member[bitcast<u32>(select(0i, _e3833, (_e3833 > 0i)))];
let _e3845 = ((_e3827 >> bitcast<u32>((_e3818 & 31u))) | ((_e3838 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3818) & 31u))));
let _e3848 = local_8.member_1[2u];
let _e3854 = f32(bitcast<i32>(((_e3845 >> bitcast<u32>((_e3848 & 31u))) & 65535u)));
let _e3857 = local_8.member_1[3u];
let _e3864 = local_9[0u];
let _e3867 = (_e3854 + ((f32(bitcast<i32>(((_e3845 >> bitcast<u32>((_e3857 & 31u))) & 65535u))) - _e3854) * _e3864));
let _e3869 = local_8.member[1u];
let _e3870 = ((_e3796 + _e3795) + _e3869);
let _e3872 = (_e3870 >> bitcast<u32>(1i));
let _e3875 = bitcast<u32>(((_e3870 & 1i) * 16i));
let _e3877 = select(_e3820, _e3872, (_e3872 < _e3820));
let _e3882 = global_2.member[bitcast<u32>(select(0i, _e3877, (_e3877 > 0i)))];
let _e3886 = (_e3872 + 1i);
let _e3888 = select(_e3820, _e3886, (_e3886 < _e3820));
let _e3893 = global_2.member[bitcast<u32>(select(0i, _e3888, (_e3888 > 0i)))];
let _e3900 = ((_e3882 >> bitcast<u32>((_e3875 & 31u))) | ((_e3893 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3875) & 31u))));
let _e3901 = local_8.member_1[2u];
let _e3907 = f32(bitcast<i32>(((_e3900 >> bitcast<u32>((_e3901 & 31u))) & 65535u)));
let _e3908 = local_8.member_1[3u];
let _e3915 = local_9[0u];
let _e3920 = local_9[1u];
let _e3923 = (_e3867 + (((_e3907 + ((f32(bitcast<i32>(((_e3900 >> bitcast<u32>((_e3908 & 31u))) & 65535u))) - _e3907) * _e3915)) - _e3867) * _e3920));
let _e3925 = local_8.member[1u];
let _e3926 = ((_e3797 + _e3794) + _e3925);
let _e3928 = (_e3926 >> bitcast<u32>(1i));
let _e3931 = bitcast<u32>(((_e3926 & 1i) * 16i));
let _e3933 = select(_e3820, _e3928, (_e3928 < _e3820));
let _e3938 = global_2.member[bitcast<u32>(select(0i, _e3933, (_e3933 > 0i)))];
let _e3942 = (_e3928 + 1i);
let _e3944 = select(_e3820, _e3942, (_e3942 < _e3820));
let _e3949 = global_2.member[bitcast<u32>(select(0i, _e3944, (_e3944 > 0i)))];
let _e3956 = ((_e3938 >> bitcast<u32>((_e3931 & 31u))) | ((_e3949 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3931) & 31u))));
let _e3957 = local_8.member_1[2u];
let _e3963 = f32(bitcast<i32>(((_e3956 >> bitcast<u32>((_e3957 & 31u))) & 65535u)));
let _e3964 = local_8.member_1[3u];
let _e3971 = local_9[0u];
let _e3974 = (_e3963 + ((f32(bitcast<i32>(((_e3956 >> bitcast<u32>((_e3964 & 31u))) & 65535u))) - _e3963) * _e3971));
let _e3976 = local_8.member[1u];
let _e3977 = ((_e3797 + _e3795) + _e3976);
let _e3979 = (_e3977 >> bitcast<u32>(1i));
let _e3982 = bitcast<u32>(((_e3977 & 1i) * 16i));
let _e3984 = select(_e3820, _e3979, (_e3979 < _e3820));
let _e3989 = global_2.member[bitcast<u32>(select(0i, _e3984, (_e3984 > 0i)))];
let _e3993 = (_e3979 + 1i);
let _e3995 = select(_e3820, _e3993, (_e3993 < _e3820));
let _e4000 = global_2.member[bitcast<u32>(select(0i, _e3995, (_e3995 > 0i)))];
let _e4007 = ((_e3989 >> bitcast<u32>((_e3982 & 31u))) | ((_e4000 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3982) & 31u))));
let _e4008 = local_8.member_1[2u];
let _e4014 = f32(bitcast<i32>(((_e4007 >> bitcast<u32>((_e4008 & 31u))) & 65535u)));
let _e4015 = local_8.member_1[3u];
let _e4022 = local_9[0u];
let _e4026 = local_9[1u];
let _e4031 = local_9[2u];
let _e4038 = global_1.member.member_8.member_6;
let _e4042 = global_1.member.member_8.member_5;
let _e4044 = (((_e3923 + (((_e3974 + (((_e4014 + ((f32(bitcast<i32>(((_e4007 >> bitcast<u32>((_e4015 & 31u))) & 65535u))) - _e4014) * _e4022)) - _e3974) * _e4026)) - _e3923) * _e4031)) - _e4038) * _e4042);
let _e4045 = -(1e9f);
let _e4047 = select(_e4045, _e4044, (_e4044 > _e4045));
let _e4049 = select(1e9f, _e4047, (_e4047 < 1e9f));
let _e4052 = global_1.member.member_1;
let _e4054 = ((_e4052 & 16u) == 0u);
if _e4054 {
phi_9205_ = type_7(1f, 1f, 1f);
} else {
let _e4058 = global_1.member.member_16.member;
let _e4069 = ((((_e4058.member.member * _e1127) + (_e4058.member.member_1 * _e1140)) + (_e4058.member.member_2 * _e1105)) + _e4058.member_1);
let _e4075 = ((((_e4058.member.member * _e1150) + (_e4058.member.member_1 * _e1155)) + (_e4058.member.member_2 * _e1144)) + _e4058.member_1);
let _e4077 = select(_e4075, _e4069, (_e4069 < _e4075));
let _e4079 = select(_e4075, _e4069, (_e4069 > _e4075));
let _e4081 = (_e4079 - _e4077);
let _e4084 = (-(_e4077) / select(1e-30f, _e4081, (_e4081 > 1e-30f)));
let _e4086 = select(0f, _e4084, (_e4084 > 0f));
let _e4092 = select(select(select(1f, _e4086, (_e4086 < 1f)), 1f, (_e4079 <= 0f)), 0f, (_e4077 > 0f));
let _e4097 = global_1.member.member_16.member_1;
let _e4098 = (_e4097 != 0u);
let _e4108 = global_1.member.member_17.member;
let _e4119 = ((((_e4108.member.member * _e1127) + (_e4108.member.member_1 * _e1140)) + (_e4108.member.member_2 * _e1105)) + _e4108.member_1);
let _e4125 = ((((_e4108.member.member * _e1150) + (_e4108.member.member_1 * _e1155)) + (_e4108.member.member_2 * _e1144)) + _e4108.member_1);
let _e4127 = select(_e4125, _e4119, (_e4119 < _e4125));
let _e4129 = select(_e4125, _e4119, (_e4119 > _e4125));
let _e4131 = (_e4129 - _e4127);
let _e4134 = (-(_e4127) / select(1e-30f, _e4131, (_e4131 > 1e-30f)));
let _e4136 = select(0f, _e4134, (_e4134 > 0f));
let _e4142 = select(select(select(1f, _e4136, (_e4136 < 1f)), 1f, (_e4129 <= 0f)), 0f, (_e4127 > 0f));
let _e4147 = global_1.member.member_17.member_1;
let _e4148 = (_e4147 != 0u);
let _e4158 = global_1.member.member_18.member;
let _e4169 = ((((_e4158.member.member * _e1127) + (_e4158.member.member_1 * _e1140)) + (_e4158.member.member_2 * _e1105)) + _e4158.member_1);
let _e4175 = ((((_e4158.member.member * _e1150) + (_e4158.member.member_1 * _e1155)) + (_e4158.member.member_2 * _e1144)) + _e4158.member_1);
let _e4177 = select(_e4175, _e4169, (_e4169 < _e4175));
let _e4179 = select(_e4175, _e4169, (_e4169 > _e4175));
let _e4181 = (_e4179 - _e4177);
let _e4184 = (-(_e4177) / select(1e-30f, _e4181, (_e4181 > 1e-30f)));
let _e4186 = select(0f, _e4184, (_e4184 > 0f));
let _e4192 = select(select(select(1f, _e4186, (_e4186 < 1f)), 1f, (_e4179 <= 0f)), 0f, (_e4177 > 0f));
let _e4197 = global_1.member.member_18.member_1;
let _e4198 = (_e4197 != 0u);
let _e4208 = global_1.member.member_19.member;
let _e4219 = ((((_e4208.member.member * _e1127) + (_e4208.member.member_1 * _e1140)) + (_e4208.member.member_2 * _e1105)) + _e4208.member_1);
let _e4225 = ((((_e4208.member.member * _e1150) + (_e4208.member.member_1 * _e1155)) + (_e4208.member.member_2 * _e1144)) + _e4208.member_1);
let _e4227 = select(_e4225, _e4219, (_e4219 < _e4225));
let _e4229 = select(_e4225, _e4219, (_e4219 > _e4225));
let _e4231 = (_e4229 - _e4227);
let _e4234 = (-(_e4227) / select(1e-30f, _e4231, (_e4231 > 1e-30f)));
let _e4236 = select(0f, _e4234, (_e4234 > 0f));
let _e4242 = select(select(select(1f, _e4236, (_e4236 < 1f)), 1f, (_e4229 <= 0f)), 0f, (_e4227 > 0f));
let _e4247 = global_1.member.member_19.member_1;
let _e4248 = (_e4247 != 0u);
phi_9205_ = type_7(((((1f * _e4092) * _e4142) * _e4192) * _e4242), ((((1f * select(1f, _e4092, _e4098)) * select(1f, _e4142, _e4148)) * select(1f, _e4192, _e4198)) * select(1f, _e4242, _e4248)), ((((1f * select(1f, 0f, (_e4098 && (_e4075 > 0f)))) * select(1f, 0f, (_e4148 && (_e4125 > 0f)))) * select(1f, 0f, (_e4198 && (_e4175 > 0f)))) * select(1f, 0f, (_e4248 && (_e4225 > 0f)))));
}
let _e4257 = phi_9205_;
let _e4258 = (_e1206 - _e1170);
let _e4262 = (bitcast<f32>((bitcast<u32>(_e4258) & 2147483647u)) < 1e-12f);
let _e4264 = (1f / select(_e4258, 1f, _e4262));
let _e4265 = (-0.5f - _e1170);
let _e4266 = (_e4265 * _e4264);
let _e4268 = ((_e3644 - _e1170) * _e4264);
let _e4274 = select(_e4268, _e4266, (_e4266 < _e4268));
let _e4276 = select(0f, _e4274, (_e4274 > 0f));
let _e4279 = select(select(1f, _e4276, (_e4276 < 1f)), select(2f, 0f, ((_e1170 >= -0.5f) && (_e1170 <= _e3644))), _e4262);
let _e4281 = select(_e4268, _e4266, (_e4266 > _e4268));
let _e4283 = select(0f, _e4281, (_e4281 > 0f));
let _e4286 = select(select(1f, _e4283, (_e4283 < 1f)), 1f, _e4262);
let _e4287 = (_e1212 - _e1185);
let _e4291 = (bitcast<f32>((bitcast<u32>(_e4287) & 2147483647u)) < 1e-12f);
let _e4293 = (1f / select(_e4287, 1f, _e4291));
let _e4294 = (-0.5f - _e1185);
let _e4295 = (_e4294 * _e4293);
let _e4297 = ((_e3654 - _e1185) * _e4293);
let _e4303 = select(_e4297, _e4295, (_e4295 < _e4297));
let _e4305 = select(0f, _e4303, (_e4303 > 0f));
let _e4308 = select(select(1f, _e4305, (_e4305 < 1f)), select(2f, 0f, ((_e1185 >= -0.5f) && (_e1185 <= _e3654))), _e4291);
let _e4310 = select(_e4297, _e4295, (_e4295 > _e4297));
let _e4312 = select(0f, _e4310, (_e4310 > 0f));
let _e4315 = select(select(1f, _e4312, (_e4312 < 1f)), 1f, _e4291);
let _e4316 = (_e1218 - _e1200);
let _e4320 = (bitcast<f32>((bitcast<u32>(_e4316) & 2147483647u)) < 1e-12f);
let _e4322 = (1f / select(_e4316, 1f, _e4320));
let _e4323 = (-0.5f - _e1200);
let _e4324 = (_e4323 * _e4322);
let _e4326 = ((_e3664 - _e1200) * _e4322);
let _e4332 = select(_e4326, _e4324, (_e4324 < _e4326));
let _e4334 = select(0f, _e4332, (_e4332 > 0f));
let _e4337 = select(select(1f, _e4334, (_e4334 < 1f)), select(2f, 0f, ((_e1200 >= -0.5f) && (_e1200 <= _e3664))), _e4320);
let _e4339 = select(_e4326, _e4324, (_e4324 > _e4326));
let _e4341 = select(0f, _e4339, (_e4339 > 0f));
let _e4344 = select(select(1f, _e4341, (_e4341 < 1f)), 1f, _e4320);
let _e4346 = select(_e4315, _e4286, (_e4286 < _e4315));
let _e4350 = select(_e4308, _e4279, (_e4279 > _e4308));
let _e4353 = (select(_e4344, _e4346, (_e4346 < _e4344)) - select(_e4337, _e4350, (_e4350 > _e4337)));
let _e4356 = (_e1150 - _e1127);
let _e4357 = (_e1155 - _e1140);
let _e4358 = (_e1144 - _e1105);
let _e4363 = (((_e4356 * _e4356) + (_e4357 * _e4357)) + (_e4358 * _e4358));
let _e4371 = global_1.member.member_7.member_3;
let _e4372 = ((sqrt(select(0f, _e4363, (_e4363 > 0f))) * select(0f, _e4353, (_e4353 > 0f))) * _e4371);
if (((_e173.member_2 == 3u) || (_e173.member_2 == 4u)) || _e1220) {
local_7 = _e4049;
let _e4378 = local_7;
let _e4380 = (bitcast<i32>(_e163) - 1i);
let _e4382 = select(_e4380, 263171i, (263171i < _e4380));
let _e4387 = global_3.member[bitcast<u32>(select(0i, _e4382, (_e4382 > 0i)))];
let _e4388 = bitcast<f32>(_e4387);
let _e4390 = select(_e4380, 263172i, (263172i < _e4380));
let _e4395 = global_3.member[bitcast<u32>(select(0i, _e4390, (_e4390 > 0i)))];
let _e4396 = bitcast<f32>(_e4395);
let _e4398 = select(_e4380, 263173i, (263173i < _e4380));
let _e4403 = global_3.member[bitcast<u32>(select(0i, _e4398, (_e4398 > 0i)))];
let _e4404 = bitcast<f32>(_e4403);
let _e4406 = ((_e4378 - _e4388) * _e4396);
let _e4408 = select(0f, _e4406, (_e4406 > 0f));
let _e4411 = local_7;
let _e4413 = select(_e4380, 263174i, (263174i < _e4380));
let _e4418 = global_3.member[bitcast<u32>(select(0i, _e4413, (_e4413 > 0i)))];
let _e4419 = bitcast<f32>(_e4418);
let _e4421 = select(_e4380, 263175i, (263175i < _e4380));
let _e4426 = global_3.member[bitcast<u32>(select(0i, _e4421, (_e4421 > 0i)))];
let _e4427 = bitcast<f32>(_e4426);
let _e4429 = select(_e4380, 263176i, (263176i < _e4380));
let _e4434 = global_3.member[bitcast<u32>(select(0i, _e4429, (_e4429 > 0i)))];
let _e4435 = bitcast<f32>(_e4434);
let _e4437 = ((_e4411 - _e4419) * _e4427);
let _e4439 = select(0f, _e4437, (_e4437 > 0f));
let _e4443 = local_7;
let _e4445 = select(_e4380, 263177i, (263177i < _e4380));
let _e4450 = global_3.member[bitcast<u32>(select(0i, _e4445, (_e4445 > 0i)))];
let _e4451 = bitcast<f32>(_e4450);
let _e4453 = select(_e4380, 263178i, (263178i < _e4380));
let _e4458 = global_3.member[bitcast<u32>(select(0i, _e4453, (_e4453 > 0i)))];
let _e4459 = bitcast<f32>(_e4458);
let _e4461 = select(_e4380, 263179i, (263179i < _e4380));
let _e4466 = global_3.member[bitcast<u32>(select(0i, _e4461, (_e4461 > 0i)))];
let _e4467 = bitcast<f32>(_e4466);
let _e4469 = ((_e4443 - _e4451) * _e4459);
let _e4471 = select(0f, _e4469, (_e4469 > 0f));
let _e4474 = local_7;
let _e4476 = select(_e4380, 263180i, (263180i < _e4380));
let _e4481 = global_3.member[bitcast<u32>(select(0i, _e4476, (_e4476 > 0i)))];
let _e4482 = bitcast<f32>(_e4481);
let _e4484 = select(_e4380, 263181i, (263181i < _e4380));
let _e4489 = global_3.member[bitcast<u32>(select(0i, _e4484, (_e4484 > 0i)))];
let _e4490 = bitcast<f32>(_e4489);
let _e4492 = select(_e4380, 263182i, (263182i < _e4380));
let _e4497 = global_3.member[bitcast<u32>(select(0i, _e4492, (_e4492 > 0i)))];
let _e4498 = bitcast<f32>(_e4497);
let _e4500 = ((_e4474 - _e4482) * _e4490);
let _e4502 = select(0f, _e4500, (_e4500 > 0f));
let _e4507 = local_7;
let _e4509 = select(_e4380, 263183i, (263183i < _e4380));
let _e4514 = global_3.member[bitcast<u32>(select(0i, _e4509, (_e4509 > 0i)))];
let _e4515 = bitcast<f32>(_e4514);
let _e4517 = select(_e4380, 263184i, (263184i < _e4380));
let _e4522 = global_3.member[bitcast<u32>(select(0i, _e4517, (_e4517 > 0i)))];
let _e4523 = bitcast<f32>(_e4522);
let _e4525 = select(_e4380, 263185i, (263185i < _e4380));
let _e4530 = global_3.member[bitcast<u32>(select(0i, _e4525, (_e4525 > 0i)))];
let _e4531 = bitcast<f32>(_e4530);
let _e4533 = ((_e4507 - _e4515) * _e4523);
let _e4535 = select(0f, _e4533, (_e4533 > 0f));
let _e4538 = local_7;
let _e4540 = select(_e4380, 263186i, (263186i < _e4380));
let _e4545 = global_3.member[bitcast<u32>(select(0i, _e4540, (_e4540 > 0i)))];
let _e4546 = bitcast<f32>(_e4545);
let _e4548 = select(_e4380, 263187i, (263187i < _e4380));
let _e4553 = global_3.member[bitcast<u32>(select(0i, _e4548, (_e4548 > 0i)))];
let _e4554 = bitcast<f32>(_e4553);
let _e4556 = select(_e4380, 263188i, (263188i < _e4380));
let _e4561 = global_3.member[bitcast<u32>(select(0i, _e4556, (_e4556 > 0i)))];
let _e4562 = bitcast<f32>(_e4561);
let _e4564 = ((_e4538 - _e4546) * _e4554);
let _e4566 = select(0f, _e4564, (_e4564 > 0f));
let _e4570 = local_7;
let _e4572 = select(_e4380, 263189i, (263189i < _e4380));
let _e4577 = global_3.member[bitcast<u32>(select(0i, _e4572, (_e4572 > 0i)))];
let _e4578 = bitcast<f32>(_e4577);
let _e4580 = select(_e4380, 263190i, (263190i < _e4380));
let _e4585 = global_3.member[bitcast<u32>(select(0i, _e4580, (_e4580 > 0i)))];
let _e4586 = bitcast<f32>(_e4585);
let _e4588 = select(_e4380, 263191i, (263191i < _e4380));
let _e4593 = global_3.member[bitcast<u32>(select(0i, _e4588, (_e4588 > 0i)))];
let _e4594 = bitcast<f32>(_e4593);
let _e4596 = ((_e4570 - _e4578) * _e4586);
let _e4598 = select(0f, _e4596, (_e4596 > 0f));
let _e4601 = local_7;
let _e4603 = select(_e4380, 263192i, (263192i < _e4380));
let _e4608 = global_3.member[bitcast<u32>(select(0i, _e4603, (_e4603 > 0i)))];
let _e4609 = bitcast<f32>(_e4608);
let _e4611 = select(_e4380, 263193i, (263193i < _e4380));
let _e4616 = global_3.member[bitcast<u32>(select(0i, _e4611, (_e4611 > 0i)))];
let _e4617 = bitcast<f32>(_e4616);
let _e4619 = select(_e4380, 263194i, (263194i < _e4380));
let _e4624 = global_3.member[bitcast<u32>(select(0i, _e4619, (_e4619 > 0i)))];
let _e4625 = bitcast<f32>(_e4624);
let _e4627 = ((_e4601 - _e4609) * _e4617);
let _e4629 = select(0f, _e4627, (_e4627 > 0f));
let _e4634 = (((select(_e4404, _e4408, (_e4408 < _e4404)) + select(_e4435, _e4439, (_e4439 < _e4435))) + (select(_e4467, _e4471, (_e4471 < _e4467)) + select(_e4498, _e4502, (_e4502 < _e4498)))) + ((select(_e4531, _e4535, (_e4535 < _e4531)) + select(_e4562, _e4566, (_e4566 < _e4562))) + (select(_e4594, _e4598, (_e4598 < _e4594)) + select(_e4625, _e4629, (_e4629 < _e4625)))));
local_6 = _e3638.member;
let _e4635 = local_6;
let _e4637 = ((_e4635 - _e4388) * _e4396);
let _e4639 = select(0f, _e4637, (_e4637 > 0f));
let _e4642 = local_6;
let _e4644 = ((_e4642 - _e4419) * _e4427);
let _e4646 = select(0f, _e4644, (_e4644 > 0f));
let _e4650 = local_6;
let _e4652 = ((_e4650 - _e4451) * _e4459);
let _e4654 = select(0f, _e4652, (_e4652 > 0f));
let _e4657 = local_6;
let _e4659 = ((_e4657 - _e4482) * _e4490);
let _e4661 = select(0f, _e4659, (_e4659 > 0f));
let _e4666 = local_6;
let _e4668 = ((_e4666 - _e4515) * _e4523);
let _e4670 = select(0f, _e4668, (_e4668 > 0f));
let _e4673 = local_6;
let _e4675 = ((_e4673 - _e4546) * _e4554);
let _e4677 = select(0f, _e4675, (_e4675 > 0f));
let _e4681 = local_6;
let _e4683 = ((_e4681 - _e4578) * _e4586);
let _e4685 = select(0f, _e4683, (_e4683 > 0f));
let _e4688 = local_6;
let _e4690 = ((_e4688 - _e4609) * _e4617);
let _e4692 = select(0f, _e4690, (_e4690 > 0f));
let _e4697 = (((select(_e4404, _e4639, (_e4639 < _e4404)) + select(_e4435, _e4646, (_e4646 < _e4435))) + (select(_e4467, _e4654, (_e4654 < _e4467)) + select(_e4498, _e4661, (_e4661 < _e4498)))) + ((select(_e4531, _e4670, (_e4670 < _e4531)) + select(_e4562, _e4677, (_e4677 < _e4562))) + (select(_e4594, _e4685, (_e4685 < _e4594)) + select(_e4625, _e4692, (_e4692 < _e4625)))));
let _e4698 = (255f - 1f);
let _e4700 = select(0f, _e4634, (_e4634 > 0f));
let _e4702 = select(_e4698, _e4700, (_e4700 < _e4698));
let _e4709 = select(0i, select(select(i32(_e4702), i32(-2147483648), (_e4702 < -2147483600f)), 2147483647i, (_e4702 > 2147483500f)), (_e4702 == _e4702));
let _e4713 = (_e4709 - select(0i, 1i, (_e4702 < f32(_e4709))));
let _e4715 = select(0f, _e4697, (_e4697 > 0f));
let _e4717 = select(_e4698, _e4715, (_e4715 < _e4698));
let _e4724 = select(0i, select(select(i32(_e4717), i32(-2147483648), (_e4717 < -2147483600f)), 2147483647i, (_e4717 > 2147483500f)), (_e4717 == _e4717));
let _e4728 = (_e4724 - select(0i, 1i, (_e4717 < f32(_e4724))));
let _e4730 = select(_e4380, 263195i, (263195i < _e4380));
let _e4736 = global_3.member[bitcast<u32>(select(0i, _e4730, (_e4730 > 0i)))];
let _e4737 = bitcast<f32>(_e4736);
let _e4739 = select(_e4380, 263196i, (263196i < _e4380));
let _e4745 = global_3.member[bitcast<u32>(select(0i, _e4739, (_e4739 > 0i)))];
let _e4746 = bitcast<f32>(_e4745);
let _e4747 = (_e3638.member - _e4049);
let _e4753 = (1f / select(_e4747, 1f, (bitcast<f32>((bitcast<u32>(_e4747) & 2147483647u)) < 1e-20f)));
let _e4759 = ((select(_e4737, _e3638.member, (_e3638.member < _e4737)) - select(_e4737, _e4049, (_e4049 < _e4737))) * _e4753);
let _e4765 = ((select(_e4746, _e3638.member, (_e3638.member > _e4746)) - select(_e4746, _e4049, (_e4049 > _e4746))) * _e4753);
let _e4768 = (((_e4713 * 256i) + _e4728) * 4i);
let _e4772 = (_e4697 - f32(_e4728));
let _e4776 = select(_e4380, _e4768, (_e4768 < _e4380));
let _e4782 = global_3.member[bitcast<u32>(select(0i, _e4776, (_e4776 > 0i)))];
let _e4783 = (_e4768 + 4i);
let _e4785 = select(_e4380, _e4783, (_e4783 < _e4380));
let _e4791 = global_3.member[bitcast<u32>(select(0i, _e4785, (_e4785 > 0i)))];
let _e4792 = (_e4768 + 1024i);
let _e4794 = select(_e4380, _e4792, (_e4792 < _e4380));
let _e4800 = global_3.member[bitcast<u32>(select(0i, _e4794, (_e4794 > 0i)))];
let _e4801 = (_e4768 + 1028i);
let _e4803 = select(_e4380, _e4801, (_e4801 < _e4380));
let _e4809 = global_3.member[bitcast<u32>(select(0i, _e4803, (_e4803 > 0i)))];
let _e4811 = select(_e4380, 0i, (0i < _e4380));
let _e4817 = global_3.member[bitcast<u32>(select(0i, _e4811, (_e4811 > 0i)))];
let _e4819 = select(_e4380, 262140i, (262140i < _e4380));
let _e4825 = global_3.member[bitcast<u32>(select(0i, _e4819, (_e4819 > 0i)))];
let _e4830 = (bitcast<f32>(((_e4782 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4838 = (_e4830 + (((bitcast<f32>(((_e4791 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4830) * _e4772));
let _e4843 = (bitcast<f32>(((_e4800 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4869 = (((_e4838 + (((_e4843 + (((bitcast<f32>(((_e4809 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4843) * _e4772)) - _e4838) * (_e4634 - f32(_e4713)))) * (1f - (_e4759 + _e4765))) + (((bitcast<f32>(((_e4817 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4759) + ((bitcast<f32>(((_e4825 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4765)));
let _e4873 = -((_e4869 * (_e4372 * _e4257.member)));
let _e4875 = select(-87f, _e4873, (_e4873 > -87f));
let _e4877 = select(88f, _e4875, (_e4875 < 88f));
let _e4879 = ((_e4877 * 1.442695f) + 0.5f);
let _e4881 = select(-127f, _e4879, (_e4879 > -127f));
let _e4883 = select(128f, _e4881, (_e4881 < 128f));
let _e4890 = select(0i, select(select(i32(_e4883), i32(-2147483648), (_e4883 < -2147483600f)), 2147483647i, (_e4883 > 2147483500f)), (_e4883 == _e4883));
let _e4894 = (_e4890 - select(0i, 1i, (_e4883 < f32(_e4890))));
let _e4895 = f32(_e4894);
let _e4899 = ((_e4877 - (_e4895 * 0.6933594f)) - (_e4895 * -2.1219444e-4f));
let _e4919 = ((1f + (_e4899 * (1f + (_e4899 * (0.5f + (_e4899 * (0.16666667f + (_e4899 * (0.041666668f + (_e4899 * (0.008333334f + (_e4899 * (0.001388889f + (_e4899 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4894 + 127i)) << bitcast<u32>(23i))));
let _e4920 = (1f - _e4919);
phi_12933_ = type_35(_e4919, _e4920, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4920 / select(1e-12f, _e4869, (_e4869 > 1e-12f))))));
} else {
local_5 = _e4049;
let _e4928 = local_5;
let _e4930 = (bitcast<i32>(_e163) - 1i);
let _e4932 = select(_e4930, 263171i, (263171i < _e4930));
let _e4937 = global_3.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4938 = bitcast<f32>(_e4937);
let _e4940 = select(_e4930, 263172i, (263172i < _e4930));
let _e4945 = global_3.member[bitcast<u32>(select(0i, _e4940, (_e4940 > 0i)))];
let _e4946 = bitcast<f32>(_e4945);
let _e4948 = select(_e4930, 263173i, (263173i < _e4930));
let _e4953 = global_3.member[bitcast<u32>(select(0i, _e4948, (_e4948 > 0i)))];
let _e4954 = bitcast<f32>(_e4953);
let _e4956 = ((_e4928 - _e4938) * _e4946);
let _e4958 = select(0f, _e4956, (_e4956 > 0f));
let _e4961 = local_5;
let _e4963 = select(_e4930, 263174i, (263174i < _e4930));
let _e4968 = global_3.member[bitcast<u32>(select(0i, _e4963, (_e4963 > 0i)))];
let _e4969 = bitcast<f32>(_e4968);
let _e4971 = select(_e4930, 263175i, (263175i < _e4930));
let _e4976 = global_3.member[bitcast<u32>(select(0i, _e4971, (_e4971 > 0i)))];
let _e4977 = bitcast<f32>(_e4976);
let _e4979 = select(_e4930, 263176i, (263176i < _e4930));
let _e4984 = global_3.member[bitcast<u32>(select(0i, _e4979, (_e4979 > 0i)))];
let _e4985 = bitcast<f32>(_e4984);
let _e4987 = ((_e4961 - _e4969) * _e4977);
let _e4989 = select(0f, _e4987, (_e4987 > 0f));
let _e4993 = local_5;
let _e4995 = select(_e4930, 263177i, (263177i < _e4930));
let _e5000 = global_3.member[bitcast<u32>(select(0i, _e4995, (_e4995 > 0i)))];
let _e5001 = bitcast<f32>(_e5000);
let _e5003 = select(_e4930, 263178i, (263178i < _e4930));
let _e5008 = global_3.member[bitcast<u32>(select(0i, _e5003, (_e5003 > 0i)))];
let _e5009 = bitcast<f32>(_e5008);
let _e5011 = select(_e4930, 263179i, (263179i < _e4930));
let _e5016 = global_3.member[bitcast<u32>(select(0i, _e5011, (_e5011 > 0i)))];
let _e5017 = bitcast<f32>(_e5016);
let _e5019 = ((_e4993 - _e5001) * _e5009);
let _e5021 = select(0f, _e5019, (_e5019 > 0f));
let _e5024 = local_5;
let _e5026 = select(_e4930, 263180i, (263180i < _e4930));
let _e5031 = global_3.member[bitcast<u32>(select(0i, _e5026, (_e5026 > 0i)))];
let _e5032 = bitcast<f32>(_e5031);
let _e5034 = select(_e4930, 263181i, (263181i < _e4930));
let _e5039 = global_3.member[bitcast<u32>(select(0i, _e5034, (_e5034 > 0i)))];
let _e5040 = bitcast<f32>(_e5039);
let _e5042 = select(_e4930, 263182i, (263182i < _e4930));
let _e5047 = global_3.member[bitcast<u32>(select(0i, _e5042, (_e5042 > 0i)))];
let _e5048 = bitcast<f32>(_e5047);
let _e5050 = ((_e5024 - _e5032) * _e5040);
let _e5052 = select(0f, _e5050, (_e5050 > 0f));
let _e5057 = local_5;
let _e5059 = select(_e4930, 263183i, (263183i < _e4930));
let _e5064 = global_3.member[bitcast<u32>(select(0i, _e5059, (_e5059 > 0i)))];
let _e5065 = bitcast<f32>(_e5064);
let _e5067 = select(_e4930, 263184i, (263184i < _e4930));
let _e5072 = global_3.member[bitcast<u32>(select(0i, _e5067, (_e5067 > 0i)))];
let _e5073 = bitcast<f32>(_e5072);
let _e5075 = select(_e4930, 263185i, (263185i < _e4930));
let _e5080 = global_3.member[bitcast<u32>(select(0i, _e5075, (_e5075 > 0i)))];
let _e5081 = bitcast<f32>(_e5080);
let _e5083 = ((_e5057 - _e5065) * _e5073);
let _e5085 = select(0f, _e5083, (_e5083 > 0f));
let _e5088 = local_5;
let _e5090 = select(_e4930, 263186i, (263186i < _e4930));
let _e5095 = global_3.member[bitcast<u32>(select(0i, _e5090, (_e5090 > 0i)))];
let _e5096 = bitcast<f32>(_e5095);
let _e5098 = select(_e4930, 263187i, (263187i < _e4930));
let _e5103 = global_3.member[bitcast<u32>(select(0i, _e5098, (_e5098 > 0i)))];
let _e5104 = bitcast<f32>(_e5103);
let _e5106 = select(_e4930, 263188i, (263188i < _e4930));
let _e5111 = global_3.member[bitcast<u32>(select(0i, _e5106, (_e5106 > 0i)))];
let _e5112 = bitcast<f32>(_e5111);
let _e5114 = ((_e5088 - _e5096) * _e5104);
let _e5116 = select(0f, _e5114, (_e5114 > 0f));
let _e5120 = local_5;
let _e5122 = select(_e4930, 263189i, (263189i < _e4930));
let _e5127 = global_3.member[bitcast<u32>(select(0i, _e5122, (_e5122 > 0i)))];
let _e5128 = bitcast<f32>(_e5127);
let _e5130 = select(_e4930, 263190i, (263190i < _e4930));
let _e5135 = global_3.member[bitcast<u32>(select(0i, _e5130, (_e5130 > 0i)))];
let _e5136 = bitcast<f32>(_e5135);
let _e5138 = select(_e4930, 263191i, (263191i < _e4930));
let _e5143 = global_3.member[bitcast<u32>(select(0i, _e5138, (_e5138 > 0i)))];
let _e5144 = bitcast<f32>(_e5143);
let _e5146 = ((_e5120 - _e5128) * _e5136);
let _e5148 = select(0f, _e5146, (_e5146 > 0f));
let _e5151 = local_5;
let _e5153 = select(_e4930, 263192i, (263192i < _e4930));
let _e5158 = global_3.member[bitcast<u32>(select(0i, _e5153, (_e5153 > 0i)))];
let _e5159 = bitcast<f32>(_e5158);
let _e5161 = select(_e4930, 263193i, (263193i < _e4930));
let _e5166 = global_3.member[bitcast<u32>(select(0i, _e5161, (_e5161 > 0i)))];
let _e5167 = bitcast<f32>(_e5166);
let _e5169 = select(_e4930, 263194i, (263194i < _e4930));
let _e5174 = global_3.member[bitcast<u32>(select(0i, _e5169, (_e5169 > 0i)))];
let _e5175 = bitcast<f32>(_e5174);
let _e5177 = ((_e5151 - _e5159) * _e5167);
let _e5179 = select(0f, _e5177, (_e5177 > 0f));
let _e5184 = (((select(_e4954, _e4958, (_e4958 < _e4954)) + select(_e4985, _e4989, (_e4989 < _e4985))) + (select(_e5017, _e5021, (_e5021 < _e5017)) + select(_e5048, _e5052, (_e5052 < _e5048)))) + ((select(_e5081, _e5085, (_e5085 < _e5081)) + select(_e5112, _e5116, (_e5116 < _e5112))) + (select(_e5144, _e5148, (_e5148 < _e5144)) + select(_e5175, _e5179, (_e5179 < _e5175)))));
local_4 = _e3638.member;
let _e5185 = local_4;
let _e5187 = ((_e5185 - _e4938) * _e4946);
let _e5189 = select(0f, _e5187, (_e5187 > 0f));
let _e5192 = local_4;
let _e5194 = ((_e5192 - _e4969) * _e4977);
let _e5196 = select(0f, _e5194, (_e5194 > 0f));
let _e5200 = local_4;
let _e5202 = ((_e5200 - _e5001) * _e5009);
let _e5204 = select(0f, _e5202, (_e5202 > 0f));
let _e5207 = local_4;
let _e5209 = ((_e5207 - _e5032) * _e5040);
let _e5211 = select(0f, _e5209, (_e5209 > 0f));
let _e5216 = local_4;
let _e5218 = ((_e5216 - _e5065) * _e5073);
let _e5220 = select(0f, _e5218, (_e5218 > 0f));
let _e5223 = local_4;
let _e5225 = ((_e5223 - _e5096) * _e5104);
let _e5227 = select(0f, _e5225, (_e5225 > 0f));
let _e5231 = local_4;
let _e5233 = ((_e5231 - _e5128) * _e5136);
let _e5235 = select(0f, _e5233, (_e5233 > 0f));
let _e5238 = local_4;
let _e5240 = ((_e5238 - _e5159) * _e5167);
let _e5242 = select(0f, _e5240, (_e5240 > 0f));
let _e5247 = (((select(_e4954, _e5189, (_e5189 < _e4954)) + select(_e4985, _e5196, (_e5196 < _e4985))) + (select(_e5017, _e5204, (_e5204 < _e5017)) + select(_e5048, _e5211, (_e5211 < _e5048)))) + ((select(_e5081, _e5220, (_e5220 < _e5081)) + select(_e5112, _e5227, (_e5227 < _e5112))) + (select(_e5144, _e5235, (_e5235 < _e5144)) + select(_e5175, _e5242, (_e5242 < _e5175)))));
let _e5248 = (255f - 1f);
let _e5250 = select(0f, _e5184, (_e5184 > 0f));
let _e5252 = select(_e5248, _e5250, (_e5250 < _e5248));
let _e5259 = select(0i, select(select(i32(_e5252), i32(-2147483648), (_e5252 < -2147483600f)), 2147483647i, (_e5252 > 2147483500f)), (_e5252 == _e5252));
let _e5263 = (_e5259 - select(0i, 1i, (_e5252 < f32(_e5259))));
let _e5265 = select(0f, _e5247, (_e5247 > 0f));
let _e5267 = select(_e5248, _e5265, (_e5265 < _e5248));
let _e5274 = select(0i, select(select(i32(_e5267), i32(-2147483648), (_e5267 < -2147483600f)), 2147483647i, (_e5267 > 2147483500f)), (_e5267 == _e5267));
let _e5278 = (_e5274 - select(0i, 1i, (_e5267 < f32(_e5274))));
let _e5280 = select(_e4930, 263195i, (263195i < _e4930));
let _e5286 = global_3.member[bitcast<u32>(select(0i, _e5280, (_e5280 > 0i)))];
let _e5287 = bitcast<f32>(_e5286);
let _e5289 = select(_e4930, 263196i, (263196i < _e4930));
let _e5295 = global_3.member[bitcast<u32>(select(0i, _e5289, (_e5289 > 0i)))];
let _e5296 = bitcast<f32>(_e5295);
let _e5297 = (_e3638.member - _e4049);
let _e5303 = (1f / select(_e5297, 1f, (bitcast<f32>((bitcast<u32>(_e5297) & 2147483647u)) < 1e-20f)));
let _e5309 = ((select(_e5287, _e3638.member, (_e3638.member < _e5287)) - select(_e5287, _e4049, (_e4049 < _e5287))) * _e5303);
let _e5315 = ((select(_e5296, _e3638.member, (_e3638.member > _e5296)) - select(_e5296, _e4049, (_e4049 > _e5296))) * _e5303);
let _e5318 = (((_e5263 * 256i) + _e5278) * 4i);
let _e5320 = (_e5184 - f32(_e5263));
let _e5322 = (_e5247 - f32(_e5278));
let _e5324 = (1f - (_e5309 + _e5315));
let _e5326 = select(_e4930, _e5318, (_e5318 < _e4930));
let _e5332 = global_3.member[bitcast<u32>(select(0i, _e5326, (_e5326 > 0i)))];
let _e5333 = (_e5318 + 4i);
let _e5335 = select(_e4930, _e5333, (_e5333 < _e4930));
let _e5341 = global_3.member[bitcast<u32>(select(0i, _e5335, (_e5335 > 0i)))];
let _e5342 = (_e5318 + 1024i);
let _e5344 = select(_e4930, _e5342, (_e5342 < _e4930));
let _e5350 = global_3.member[bitcast<u32>(select(0i, _e5344, (_e5344 > 0i)))];
let _e5351 = (_e5318 + 1028i);
let _e5353 = select(_e4930, _e5351, (_e5351 < _e4930));
let _e5359 = global_3.member[bitcast<u32>(select(0i, _e5353, (_e5353 > 0i)))];
let _e5361 = select(_e4930, 0i, (0i < _e4930));
let _e5367 = global_3.member[bitcast<u32>(select(0i, _e5361, (_e5361 > 0i)))];
let _e5369 = select(_e4930, 262140i, (262140i < _e4930));
let _e5375 = global_3.member[bitcast<u32>(select(0i, _e5369, (_e5369 > 0i)))];
let _e5380 = (bitcast<f32>(((_e5332 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5388 = (_e5380 + (((bitcast<f32>(((_e5341 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5380) * _e5322));
let _e5393 = (bitcast<f32>(((_e5350 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5419 = (((_e5388 + (((_e5393 + (((bitcast<f32>(((_e5359 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5393) * _e5322)) - _e5388) * _e5320)) * _e5324) + (((bitcast<f32>(((_e5367 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5309) + ((bitcast<f32>(((_e5375 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5315)));
let _e5436 = (bitcast<f32>((((_e5332 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5444 = (_e5436 + (((bitcast<f32>((((_e5341 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5436) * _e5322));
let _e5449 = (bitcast<f32>((((_e5350 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5476 = (_e5318 + 1i);
let _e5478 = select(_e4930, _e5476, (_e5476 < _e4930));
let _e5484 = global_3.member[bitcast<u32>(select(0i, _e5478, (_e5478 > 0i)))];
let _e5485 = (_e5318 + 5i);
let _e5487 = select(_e4930, _e5485, (_e5485 < _e4930));
let _e5493 = global_3.member[bitcast<u32>(select(0i, _e5487, (_e5487 > 0i)))];
let _e5494 = (_e5318 + 1025i);
let _e5496 = select(_e4930, _e5494, (_e5494 < _e4930));
let _e5502 = global_3.member[bitcast<u32>(select(0i, _e5496, (_e5496 > 0i)))];
let _e5503 = (_e5318 + 1029i);
let _e5505 = select(_e4930, _e5503, (_e5503 < _e4930));
let _e5511 = global_3.member[bitcast<u32>(select(0i, _e5505, (_e5505 > 0i)))];
let _e5513 = select(_e4930, 1i, (1i < _e4930));
let _e5519 = global_3.member[bitcast<u32>(select(0i, _e5513, (_e5513 > 0i)))];
let _e5521 = select(_e4930, 262141i, (262141i < _e4930));
let _e5527 = global_3.member[bitcast<u32>(select(0i, _e5521, (_e5521 > 0i)))];
let _e5532 = (bitcast<f32>(((_e5484 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5540 = (_e5532 + (((bitcast<f32>(((_e5493 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5532) * _e5322));
let _e5545 = (bitcast<f32>(((_e5502 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5588 = (bitcast<f32>((((_e5484 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5596 = (_e5588 + (((bitcast<f32>((((_e5493 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5588) * _e5322));
let _e5601 = (bitcast<f32>((((_e5502 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5631 = (_e4372 * _e4257.member_1);
let _e5633 = -(((((_e5444 + (((_e5449 + (((bitcast<f32>((((_e5359 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5449) * _e5322)) - _e5444) * _e5320)) * _e5324) + (((bitcast<f32>((((_e5367 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5309) + ((bitcast<f32>((((_e5375 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5315))) * _e5631));
let _e5635 = select(-87f, _e5633, (_e5633 > -87f));
let _e5637 = select(88f, _e5635, (_e5635 < 88f));
let _e5639 = ((_e5637 * 1.442695f) + 0.5f);
let _e5641 = select(-127f, _e5639, (_e5639 > -127f));
let _e5643 = select(128f, _e5641, (_e5641 < 128f));
let _e5650 = select(0i, select(select(i32(_e5643), i32(-2147483648), (_e5643 < -2147483600f)), 2147483647i, (_e5643 > 2147483500f)), (_e5643 == _e5643));
let _e5654 = (_e5650 - select(0i, 1i, (_e5643 < f32(_e5650))));
let _e5655 = f32(_e5654);
let _e5659 = ((_e5637 - (_e5655 * 0.6933594f)) - (_e5655 * -2.1219444e-4f));
let _e5681 = -(((((_e5540 + (((_e5545 + (((bitcast<f32>(((_e5511 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5545) * _e5322)) - _e5540) * _e5320)) * _e5324) + (((bitcast<f32>(((_e5519 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5309) + ((bitcast<f32>(((_e5527 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5315))) * _e5631));
let _e5683 = select(-87f, _e5681, (_e5681 > -87f));
let _e5685 = select(88f, _e5683, (_e5683 < 88f));
let _e5687 = ((_e5685 * 1.442695f) + 0.5f);
let _e5689 = select(-127f, _e5687, (_e5687 > -127f));
let _e5691 = select(128f, _e5689, (_e5689 < 128f));
let _e5698 = select(0i, select(select(i32(_e5691), i32(-2147483648), (_e5691 < -2147483600f)), 2147483647i, (_e5691 > 2147483500f)), (_e5691 == _e5691));
let _e5702 = (_e5698 - select(0i, 1i, (_e5691 < f32(_e5698))));
let _e5703 = f32(_e5702);
let _e5707 = ((_e5685 - (_e5703 * 0.6933594f)) - (_e5703 * -2.1219444e-4f));
let _e5729 = -(((((_e5596 + (((_e5601 + (((bitcast<f32>((((_e5511 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5601) * _e5322)) - _e5596) * _e5320)) * _e5324) + (((bitcast<f32>((((_e5519 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5309) + ((bitcast<f32>((((_e5527 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5315))) * _e5631));
let _e5731 = select(-87f, _e5729, (_e5729 > -87f));
let _e5733 = select(88f, _e5731, (_e5731 < 88f));
let _e5735 = ((_e5733 * 1.442695f) + 0.5f);
let _e5737 = select(-127f, _e5735, (_e5735 > -127f));
let _e5739 = select(128f, _e5737, (_e5737 < 128f));
let _e5746 = select(0i, select(select(i32(_e5739), i32(-2147483648), (_e5739 < -2147483600f)), 2147483647i, (_e5739 > 2147483500f)), (_e5739 == _e5739));
let _e5750 = (_e5746 - select(0i, 1i, (_e5739 < f32(_e5746))));
let _e5751 = f32(_e5750);
let _e5755 = ((_e5733 - (_e5751 * 0.6933594f)) - (_e5751 * -2.1219444e-4f));
let _e5778 = -((_e5419 * (_e4372 * _e4257.member)));
let _e5780 = select(-87f, _e5778, (_e5778 > -87f));
let _e5782 = select(88f, _e5780, (_e5780 < 88f));
let _e5784 = ((_e5782 * 1.442695f) + 0.5f);
let _e5786 = select(-127f, _e5784, (_e5784 > -127f));
let _e5788 = select(128f, _e5786, (_e5786 < 128f));
let _e5795 = select(0i, select(select(i32(_e5788), i32(-2147483648), (_e5788 < -2147483600f)), 2147483647i, (_e5788 > 2147483500f)), (_e5788 == _e5788));
let _e5799 = (_e5795 - select(0i, 1i, (_e5788 < f32(_e5795))));
let _e5800 = f32(_e5799);
let _e5804 = ((_e5782 - (_e5800 * 0.6933594f)) - (_e5800 * -2.1219444e-4f));
let _e5824 = ((1f + (_e5804 * (1f + (_e5804 * (0.5f + (_e5804 * (0.16666667f + (_e5804 * (0.041666668f + (_e5804 * (0.008333334f + (_e5804 * (0.001388889f + (_e5804 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5799 + 127i)) << bitcast<u32>(23i))));
let _e5825 = (1f - _e5824);
phi_12933_ = type_35(_e5824, _e5825, vec3<f32>(((1f + (_e5659 * (1f + (_e5659 * (0.5f + (_e5659 * (0.16666667f + (_e5659 * (0.041666668f + (_e5659 * (0.008333334f + (_e5659 * (0.001388889f + (_e5659 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5654 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5707 * (1f + (_e5707 * (0.5f + (_e5707 * (0.16666667f + (_e5707 * (0.041666668f + (_e5707 * (0.008333334f + (_e5707 * (0.001388889f + (_e5707 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5702 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5755 * (1f + (_e5755 * (0.5f + (_e5755 * (0.16666667f + (_e5755 * (0.041666668f + (_e5755 * (0.008333334f + (_e5755 * (0.001388889f + (_e5755 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5750 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5825 / select(1e-12f, _e5419, (_e5419 > 1e-12f))))));
}
let _e5833 = phi_12933_;
if _e1227 {
let _e5838 = global_1.member.member_8.member.member;
let _e5846 = global_1.member.member_8.member_1.member;
let _e5854 = global_1.member.member_8.member_2.member;
let _e5858 = (-0.5f - _e1206);
let _e5859 = -(_e4265);
let _e5862 = (_e4265 - _e5858);
let _e5863 = (_e5858 - _e4265);
let _e5865 = select(_e5863, _e5862, (_e5862 > _e5863));
let _e5868 = (select(_e5859, _e4265, (_e4265 > _e5859)) / select(1e-30f, _e5865, (_e5865 > 1e-30f)));
let _e5870 = (_e5858 < 0f);
let _e5872 = select(0f, select(2f, _e5868, _e5870), (_e4265 > 0f));
let _e5873 = (_e5858 > 0f);
let _e5876 = select(2f, select(0f, _e5868, (_e4265 < 0f)), _e5873);
let _e5877 = (_e4265 > -1e30f);
let _e5881 = ((_e5872 > -1f) || ((_e5872 == -1f) && _e5877));
let _e5882 = (_e5876 < 2f);
let _e5883 = select(-1f, _e5872, _e5881);
let _e5887 = select(2f, _e5876, _e5882);
let _e5891 = select(-1e30f, _e4265, _e5877);
let _e5892 = (_e5858 > -1e30f);
let _e5893 = select(-1e30f, _e5858, _e5892);
let _e5897 = (_e1170 - _e3644);
let _e5898 = (_e1206 - _e3644);
let _e5899 = -(_e5897);
let _e5902 = (_e5897 - _e5898);
let _e5903 = (_e5898 - _e5897);
let _e5905 = select(_e5903, _e5902, (_e5902 > _e5903));
let _e5908 = (select(_e5899, _e5897, (_e5897 > _e5899)) / select(1e-30f, _e5905, (_e5905 > 1e-30f)));
let _e5910 = (_e5898 < 0f);
let _e5912 = select(0f, select(2f, _e5908, _e5910), (_e5897 > 0f));
let _e5913 = (_e5898 > 0f);
let _e5916 = select(2f, select(0f, _e5908, (_e5897 < 0f)), _e5913);
let _e5917 = (_e5897 > _e5891);
let _e5921 = ((_e5912 > _e5883) || ((_e5912 == _e5883) && _e5917));
let _e5922 = (_e5916 < _e5887);
let _e5923 = select(_e5883, _e5912, _e5921);
let _e5927 = select(_e5887, _e5916, _e5922);
let _e5931 = select(_e5891, _e5897, _e5917);
let _e5932 = (_e5898 > _e5893);
let _e5933 = select(_e5893, _e5898, _e5932);
let _e5937 = (-0.5f - _e1212);
let _e5938 = -(_e4294);
let _e5941 = (_e4294 - _e5937);
let _e5942 = (_e5937 - _e4294);
let _e5944 = select(_e5942, _e5941, (_e5941 > _e5942));
let _e5947 = (select(_e5938, _e4294, (_e4294 > _e5938)) / select(1e-30f, _e5944, (_e5944 > 1e-30f)));
let _e5949 = (_e5937 < 0f);
let _e5951 = select(0f, select(2f, _e5947, _e5949), (_e4294 > 0f));
let _e5952 = (_e5937 > 0f);
let _e5955 = select(2f, select(0f, _e5947, (_e4294 < 0f)), _e5952);
let _e5956 = (_e4294 > _e5931);
let _e5960 = ((_e5951 > _e5923) || ((_e5951 == _e5923) && _e5956));
let _e5961 = (_e5955 < _e5927);
let _e5962 = select(_e5923, _e5951, _e5960);
let _e5966 = select(_e5927, _e5955, _e5961);
let _e5970 = select(_e5931, _e4294, _e5956);
let _e5971 = (_e5937 > _e5933);
let _e5972 = select(_e5933, _e5937, _e5971);
let _e5976 = (_e1185 - _e3654);
let _e5977 = (_e1212 - _e3654);
let _e5978 = -(_e5976);
let _e5981 = (_e5976 - _e5977);
let _e5982 = (_e5977 - _e5976);
let _e5984 = select(_e5982, _e5981, (_e5981 > _e5982));
let _e5987 = (select(_e5978, _e5976, (_e5976 > _e5978)) / select(1e-30f, _e5984, (_e5984 > 1e-30f)));
let _e5989 = (_e5977 < 0f);
let _e5991 = select(0f, select(2f, _e5987, _e5989), (_e5976 > 0f));
let _e5992 = (_e5977 > 0f);
let _e5995 = select(2f, select(0f, _e5987, (_e5976 < 0f)), _e5992);
let _e5996 = (_e5976 > _e5970);
let _e6000 = ((_e5991 > _e5962) || ((_e5991 == _e5962) && _e5996));
let _e6001 = (_e5995 < _e5966);
let _e6002 = select(_e5962, _e5991, _e6000);
let _e6006 = select(_e5966, _e5995, _e6001);
let _e6010 = select(_e5970, _e5976, _e5996);
let _e6011 = (_e5977 > _e5972);
let _e6012 = select(_e5972, _e5977, _e6011);
let _e6016 = (-0.5f - _e1218);
let _e6017 = -(_e4323);
let _e6020 = (_e4323 - _e6016);
let _e6021 = (_e6016 - _e4323);
let _e6023 = select(_e6021, _e6020, (_e6020 > _e6021));
let _e6026 = (select(_e6017, _e4323, (_e4323 > _e6017)) / select(1e-30f, _e6023, (_e6023 > 1e-30f)));
let _e6028 = (_e6016 < 0f);
let _e6030 = select(0f, select(2f, _e6026, _e6028), (_e4323 > 0f));
let _e6031 = (_e6016 > 0f);
let _e6034 = select(2f, select(0f, _e6026, (_e4323 < 0f)), _e6031);
let _e6035 = (_e4323 > _e6010);
let _e6039 = ((_e6030 > _e6002) || ((_e6030 == _e6002) && _e6035));
let _e6040 = (_e6034 < _e6006);
let _e6041 = select(_e6002, _e6030, _e6039);
let _e6045 = select(_e6006, _e6034, _e6040);
let _e6049 = select(_e6010, _e4323, _e6035);
let _e6050 = (_e6016 > _e6012);
let _e6051 = select(_e6012, _e6016, _e6050);
let _e6055 = (_e1200 - _e3664);
let _e6056 = (_e1218 - _e3664);
let _e6057 = -(_e6055);
let _e6060 = (_e6055 - _e6056);
let _e6061 = (_e6056 - _e6055);
let _e6063 = select(_e6061, _e6060, (_e6060 > _e6061));
let _e6066 = (select(_e6057, _e6055, (_e6055 > _e6057)) / select(1e-30f, _e6063, (_e6063 > 1e-30f)));
let _e6068 = (_e6056 < 0f);
let _e6070 = select(0f, select(2f, _e6066, _e6068), (_e6055 > 0f));
let _e6071 = (_e6056 > 0f);
let _e6074 = select(2f, select(0f, _e6066, (_e6055 < 0f)), _e6071);
let _e6075 = (_e6055 > _e6049);
let _e6079 = ((_e6070 > _e6041) || ((_e6070 == _e6041) && _e6075));
let _e6080 = (_e6074 < _e6045);
let _e6081 = select(_e6041, _e6070, _e6079);
let _e6082 = select(select(select(select(select(select(0f, _e5838.member, _e5881), _e5838.member, _e5921), _e5846.member, _e5960), _e5846.member, _e6000), _e5854.member, _e6039), _e5854.member, _e6079);
let _e6083 = select(select(select(select(select(select(0f, _e5838.member_1, _e5881), _e5838.member_1, _e5921), _e5846.member_1, _e5960), _e5846.member_1, _e6000), _e5854.member_1, _e6039), _e5854.member_1, _e6079);
let _e6084 = select(select(select(select(select(select(1f, _e5838.member_2, _e5881), _e5838.member_2, _e5921), _e5846.member_2, _e5960), _e5846.member_2, _e6000), _e5854.member_2, _e6039), _e5854.member_2, _e6079);
let _e6086 = select(_e6045, _e6074, _e6080);
let _e6087 = select(select(select(select(select(select(0f, _e5838.member, _e5882), _e5838.member, _e5922), _e5846.member, _e5961), _e5846.member, _e6001), _e5854.member, _e6040), _e5854.member, _e6080);
let _e6088 = select(select(select(select(select(select(0f, _e5838.member_1, _e5882), _e5838.member_1, _e5922), _e5846.member_1, _e5961), _e5846.member_1, _e6001), _e5854.member_1, _e6040), _e5854.member_1, _e6080);
let _e6089 = select(select(select(select(select(select(1f, _e5838.member_2, _e5882), _e5838.member_2, _e5922), _e5846.member_2, _e5961), _e5846.member_2, _e6001), _e5854.member_2, _e6040), _e5854.member_2, _e6080);
let _e6091 = select(_e6049, _e6055, _e6075);
let _e6092 = (_e6056 > _e6051);
let _e6093 = select(_e6051, _e6056, _e6092);
let _e6094 = select(select(select(select(select(select(0f, _e5838.member, _e5877), _e5838.member, _e5917), _e5846.member, _e5956), _e5846.member, _e5996), _e5854.member, _e6035), _e5854.member, _e6075);
let _e6095 = select(select(select(select(select(select(0f, _e5838.member_1, _e5877), _e5838.member_1, _e5917), _e5846.member_1, _e5956), _e5846.member_1, _e5996), _e5854.member_1, _e6035), _e5854.member_1, _e6075);
let _e6096 = select(select(select(select(select(select(1f, _e5838.member_2, _e5877), _e5838.member_2, _e5917), _e5846.member_2, _e5956), _e5846.member_2, _e5996), _e5854.member_2, _e6035), _e5854.member_2, _e6075);
if _e4054 {
phi_14252_ = type_34(_e6081, vec3<f32>(_e6082, _e6083, _e6084), _e6086, vec3<f32>(_e6087, _e6088, _e6089), _e6091, _e6093, vec3<f32>(_e6094, _e6095, _e6096));
} else {
let _e6103 = (((_e5838.member * _e5838.member) + (_e5838.member_1 * _e5838.member_1)) + (_e5838.member_2 * _e5838.member_2));
let _e6106 = sqrt(select(0f, _e6103, (_e6103 > 0f)));
let _e6110 = global_1.member.member_16.member_1;
let _e6111 = (_e6110 != 0u);
let _e6115 = global_1.member.member_16.member;
let _e6135 = select(-1e6f, (((((_e6115.member.member * _e1127) + (_e6115.member.member_1 * _e1140)) + (_e6115.member.member_2 * _e1105)) + _e6115.member_1) * _e6106), _e6111);
let _e6136 = select(-1e6f, (((((_e6115.member.member * _e1150) + (_e6115.member.member_1 * _e1155)) + (_e6115.member.member_2 * _e1144)) + _e6115.member_1) * _e6106), _e6111);
let _e6141 = global_1.member.member_16.member.member;
let _e6145 = -(_e6135);
let _e6148 = (_e6135 - _e6136);
let _e6149 = (_e6136 - _e6135);
let _e6151 = select(_e6149, _e6148, (_e6148 > _e6149));
let _e6154 = (select(_e6145, _e6135, (_e6135 > _e6145)) / select(1e-30f, _e6151, (_e6151 > 1e-30f)));
let _e6158 = select(0f, select(2f, _e6154, (_e6136 < 0f)), (_e6135 > 0f));
let _e6162 = select(2f, select(0f, _e6154, (_e6135 < 0f)), (_e6136 > 0f));
let _e6163 = (_e6135 > _e6091);
let _e6167 = ((_e6158 > _e6081) || ((_e6158 == _e6081) && _e6163));
let _e6168 = (_e6162 < _e6086);
let _e6169 = select(_e6081, _e6158, _e6167);
let _e6173 = select(_e6086, _e6162, _e6168);
let _e6177 = select(_e6091, _e6135, _e6163);
let _e6179 = select(_e6093, _e6136, (_e6136 > _e6093));
let _e6186 = global_1.member.member_17.member_1;
let _e6187 = (_e6186 != 0u);
let _e6191 = global_1.member.member_17.member;
let _e6211 = select(-1e6f, (((((_e6191.member.member * _e1127) + (_e6191.member.member_1 * _e1140)) + (_e6191.member.member_2 * _e1105)) + _e6191.member_1) * _e6106), _e6187);
let _e6212 = select(-1e6f, (((((_e6191.member.member * _e1150) + (_e6191.member.member_1 * _e1155)) + (_e6191.member.member_2 * _e1144)) + _e6191.member_1) * _e6106), _e6187);
let _e6217 = global_1.member.member_17.member.member;
let _e6221 = -(_e6211);
let _e6224 = (_e6211 - _e6212);
let _e6225 = (_e6212 - _e6211);
let _e6227 = select(_e6225, _e6224, (_e6224 > _e6225));
let _e6230 = (select(_e6221, _e6211, (_e6211 > _e6221)) / select(1e-30f, _e6227, (_e6227 > 1e-30f)));
let _e6234 = select(0f, select(2f, _e6230, (_e6212 < 0f)), (_e6211 > 0f));
let _e6238 = select(2f, select(0f, _e6230, (_e6211 < 0f)), (_e6212 > 0f));
let _e6239 = (_e6211 > _e6177);
let _e6243 = ((_e6234 > _e6169) || ((_e6234 == _e6169) && _e6239));
let _e6244 = (_e6238 < _e6173);
let _e6245 = select(_e6169, _e6234, _e6243);
let _e6249 = select(_e6173, _e6238, _e6244);
let _e6253 = select(_e6177, _e6211, _e6239);
let _e6255 = select(_e6179, _e6212, (_e6212 > _e6179));
let _e6262 = global_1.member.member_18.member_1;
let _e6263 = (_e6262 != 0u);
let _e6267 = global_1.member.member_18.member;
let _e6287 = select(-1e6f, (((((_e6267.member.member * _e1127) + (_e6267.member.member_1 * _e1140)) + (_e6267.member.member_2 * _e1105)) + _e6267.member_1) * _e6106), _e6263);
let _e6288 = select(-1e6f, (((((_e6267.member.member * _e1150) + (_e6267.member.member_1 * _e1155)) + (_e6267.member.member_2 * _e1144)) + _e6267.member_1) * _e6106), _e6263);
let _e6293 = global_1.member.member_18.member.member;
let _e6297 = -(_e6287);
let _e6300 = (_e6287 - _e6288);
let _e6301 = (_e6288 - _e6287);
let _e6303 = select(_e6301, _e6300, (_e6300 > _e6301));
let _e6306 = (select(_e6297, _e6287, (_e6287 > _e6297)) / select(1e-30f, _e6303, (_e6303 > 1e-30f)));
let _e6310 = select(0f, select(2f, _e6306, (_e6288 < 0f)), (_e6287 > 0f));
let _e6314 = select(2f, select(0f, _e6306, (_e6287 < 0f)), (_e6288 > 0f));
let _e6315 = (_e6287 > _e6253);
let _e6319 = ((_e6310 > _e6245) || ((_e6310 == _e6245) && _e6315));
let _e6320 = (_e6314 < _e6249);
let _e6321 = select(_e6245, _e6310, _e6319);
let _e6325 = select(_e6249, _e6314, _e6320);
let _e6329 = select(_e6253, _e6287, _e6315);
let _e6331 = select(_e6255, _e6288, (_e6288 > _e6255));
let _e6338 = global_1.member.member_19.member_1;
let _e6339 = (_e6338 != 0u);
let _e6343 = global_1.member.member_19.member;
let _e6363 = select(-1e6f, (((((_e6343.member.member * _e1127) + (_e6343.member.member_1 * _e1140)) + (_e6343.member.member_2 * _e1105)) + _e6343.member_1) * _e6106), _e6339);
let _e6364 = select(-1e6f, (((((_e6343.member.member * _e1150) + (_e6343.member.member_1 * _e1155)) + (_e6343.member.member_2 * _e1144)) + _e6343.member_1) * _e6106), _e6339);
let _e6369 = global_1.member.member_19.member.member;
let _e6373 = -(_e6363);
let _e6376 = (_e6363 - _e6364);
let _e6377 = (_e6364 - _e6363);
let _e6379 = select(_e6377, _e6376, (_e6376 > _e6377));
let _e6382 = (select(_e6373, _e6363, (_e6363 > _e6373)) / select(1e-30f, _e6379, (_e6379 > 1e-30f)));
let _e6386 = select(0f, select(2f, _e6382, (_e6364 < 0f)), (_e6363 > 0f));
let _e6390 = select(2f, select(0f, _e6382, (_e6363 < 0f)), (_e6364 > 0f));
let _e6391 = (_e6363 > _e6329);
let _e6395 = ((_e6386 > _e6321) || ((_e6386 == _e6321) && _e6391));
let _e6396 = (_e6390 < _e6325);
phi_14252_ = type_34(select(_e6321, _e6386, _e6395), vec3<f32>(select(select(select(select(_e6082, _e6141.member, _e6167), _e6217.member, _e6243), _e6293.member, _e6319), _e6369.member, _e6395), select(select(select(select(_e6083, _e6141.member_1, _e6167), _e6217.member_1, _e6243), _e6293.member_1, _e6319), _e6369.member_1, _e6395), select(select(select(select(_e6084, _e6141.member_2, _e6167), _e6217.member_2, _e6243), _e6293.member_2, _e6319), _e6369.member_2, _e6395)), select(_e6325, _e6390, _e6396), vec3<f32>(select(select(select(select(_e6087, _e6141.member, _e6168), _e6217.member, _e6244), _e6293.member, _e6320), _e6369.member, _e6396), select(select(select(select(_e6088, _e6141.member_1, _e6168), _e6217.member_1, _e6244), _e6293.member_1, _e6320), _e6369.member_1, _e6396), select(select(select(select(_e6089, _e6141.member_2, _e6168), _e6217.member_2, _e6244), _e6293.member_2, _e6320), _e6369.member_2, _e6396)), select(_e6329, _e6363, _e6391), select(_e6331, _e6364, (_e6364 > _e6331)), vec3<f32>(select(select(select(select(_e6094, _e6141.member, _e6163), _e6217.member, _e6239), _e6293.member, _e6315), _e6369.member, _e6391), select(select(select(select(_e6095, _e6141.member_1, _e6163), _e6217.member_1, _e6239), _e6293.member_1, _e6315), _e6369.member_1, _e6391), select(select(select(select(_e6096, _e6141.member_2, _e6163), _e6217.member_2, _e6239), _e6293.member_2, _e6315), _e6369.member_2, _e6391)));
}
let _e6416 = phi_14252_;
let _e6418 = (_e6416.member_4 < 0f);
let _e6420 = (_e6416.member_5 < 0f);
let _e6421 = (_e6418 != _e6420);
if _e6418 {
phi_14265_ = _e6416.member_3;
phi_14266_ = _e6416.member_2;
} else {
phi_14265_ = _e6416.member_1;
phi_14266_ = _e6416.member;
}
let _e6427 = phi_14265_;
let _e6429 = phi_14266_;
let _e6438 = (((_e5838.member * _e5838.member) + (_e5838.member_1 * _e5838.member_1)) + (_e5838.member_2 * _e5838.member_2));
let _e6441 = sqrt(select(0f, _e6438, (_e6438 > 0f)));
let _e6442 = ((1.5f * _e1125) * _e6441);
let _e6447 = select(0f, _e6429, _e6421);
let _e6451 = (_e1127 + (_e4356 * _e6447));
let _e6452 = (_e1140 + (_e4357 * _e6447));
let _e6453 = (_e1105 + (_e4358 * _e6447));
let _e6459 = ((((_e1159.member.member * _e6451) + (_e1159.member.member_1 * _e6452)) + (_e1159.member.member_2 * _e6453)) + _e1159.member_1);
let _e6465 = ((((_e1174.member.member * _e6451) + (_e1174.member.member_1 * _e6452)) + (_e1174.member.member_2 * _e6453)) + _e1174.member_1);
let _e6471 = ((((_e1189.member.member * _e6451) + (_e1189.member.member_1 * _e6452)) + (_e1189.member.member_2 * _e6453)) + _e1189.member_1);
let _e6473 = select(-0.5f, _e6459, (_e6459 > -0.5f));
let _e6475 = select(_e3644, _e6473, (_e6473 < _e3644));
let _e6477 = select(-0.5f, _e6465, (_e6465 > -0.5f));
let _e6479 = select(_e3654, _e6477, (_e6477 < _e3654));
let _e6481 = select(-0.5f, _e6471, (_e6471 > -0.5f));
let _e6483 = select(_e3664, _e6481, (_e6481 < _e3664));
let _e6485 = select(-1f, _e6475, (_e6475 > -1f));
let _e6487 = select(_e3643, _e6485, (_e6485 < _e3643));
let _e6494 = select(0i, select(select(i32(_e6487), i32(-2147483648), (_e6487 < -2147483600f)), 2147483647i, (_e6487 > 2147483500f)), (_e6487 == _e6487));
let _e6498 = (_e6494 - select(0i, 1i, (_e6487 < f32(_e6494))));
let _e6500 = select(-1f, _e6479, (_e6479 > -1f));
let _e6502 = select(_e3653, _e6500, (_e6500 < _e3653));
let _e6509 = select(0i, select(select(i32(_e6502), i32(-2147483648), (_e6502 < -2147483600f)), 2147483647i, (_e6502 > 2147483500f)), (_e6502 == _e6502));
let _e6513 = (_e6509 - select(0i, 1i, (_e6502 < f32(_e6509))));
let _e6515 = select(-1f, _e6483, (_e6483 > -1f));
let _e6517 = select(_e3663, _e6515, (_e6515 < _e3663));
let _e6524 = select(0i, select(select(i32(_e6517), i32(-2147483648), (_e6517 < -2147483600f)), 2147483647i, (_e6517 > 2147483500f)), (_e6517 == _e6517));
let _e6528 = (_e6524 - select(0i, 1i, (_e6517 < f32(_e6524))));
let _e6531 = (_e6513 + 1i);
let _e6536 = (_e6528 + 1i);
let _e6539 = (_e6498 - 1i);
let _e6541 = select(0i, _e6539, (_e6539 > 0i));
let _e6543 = select(0i, _e6498, (_e6498 > 0i));
let _e6544 = (_e6498 + 1i);
let _e6546 = select(_e3755, _e6544, (_e6544 < _e3755));
let _e6547 = (_e6498 + 2i);
let _e6551 = select(_e3769, _e6541, (_e6541 < _e3769));
let _e6553 = select(_e3769, _e6543, (_e6543 < _e3769));
let _e6555 = select(_e3769, _e6546, (_e6546 < _e3769));
let _e6574 = (select(0i, _e6513, (_e6513 > 0i)) * _e3717);
let _e6575 = (select(_e3729, _e6531, (_e6531 < _e3729)) * _e3717);
let _e6576 = (select(0i, _e6528, (_e6528 > 0i)) * _e3721);
let _e6577 = (select(_e3742, _e6536, (_e6536 < _e3742)) * _e3721);
local_2 = type_29(array<i32, 4>(_e6551, _e6553, _e6555, 0i), array<u32, 6>(bitcast<u32>(((_e6541 - _e6551) * 16i)), bitcast<u32>(((_e6543 - _e6551) * 16i)), bitcast<u32>(((_e6543 - _e6553) * 16i)), bitcast<u32>(((_e6546 - _e6553) * 16i)), bitcast<u32>(((_e6546 - _e6555) * 16i)), bitcast<u32>(((select(_e3755, _e6547, (_e6547 < _e3755)) - _e6555) * 16i))));
local_3 = vec3<f32>((_e6475 - f32(_e6498)), (_e6479 - f32(_e6513)), (_e6483 - f32(_e6528)));
let _e6592 = local_2.member[1u];
let _e6593 = ((_e6576 + _e6574) + _e6592);
let _e6595 = (_e6593 >> bitcast<u32>(1i));
let _e6598 = bitcast<u32>(((_e6593 & 1i) * 16i));
let _e6600 = select(_e3820, _e6595, (_e6595 < _e3820));
let _e6605 = global_2.member[bitcast<u32>(select(0i, _e6600, (_e6600 > 0i)))];
let _e6609 = (_e6595 + 1i);
let _e6611 = select(_e3820, _e6609, (_e6609 < _e3820));
let _e6616 = global_2.member[bitcast<u32>(select(0i, _e6611, (_e6611 > 0i)))];
let _e6623 = ((_e6605 >> bitcast<u32>((_e6598 & 31u))) | ((_e6616 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6598) & 31u))));
let _e6626 = local_2.member_1[2u];
let _e6632 = f32(bitcast<i32>(((_e6623 >> bitcast<u32>((_e6626 & 31u))) & 65535u)));
let _e6635 = local_2.member_1[3u];
let _e6642 = local_3[0u];
let _e6645 = (_e6632 + ((f32(bitcast<i32>(((_e6623 >> bitcast<u32>((_e6635 & 31u))) & 65535u))) - _e6632) * _e6642));
let _e6647 = local_2.member[1u];
let _e6648 = ((_e6576 + _e6575) + _e6647);
let _e6650 = (_e6648 >> bitcast<u32>(1i));
let _e6653 = bitcast<u32>(((_e6648 & 1i) * 16i));
let _e6655 = select(_e3820, _e6650, (_e6650 < _e3820));
let _e6660 = global_2.member[bitcast<u32>(select(0i, _e6655, (_e6655 > 0i)))];
let _e6664 = (_e6650 + 1i);
let _e6666 = select(_e3820, _e6664, (_e6664 < _e3820));
let _e6671 = global_2.member[bitcast<u32>(select(0i, _e6666, (_e6666 > 0i)))];
let _e6678 = ((_e6660 >> bitcast<u32>((_e6653 & 31u))) | ((_e6671 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6653) & 31u))));
let _e6679 = local_2.member_1[2u];
let _e6685 = f32(bitcast<i32>(((_e6678 >> bitcast<u32>((_e6679 & 31u))) & 65535u)));
let _e6686 = local_2.member_1[3u];
let _e6693 = local_3[0u];
let _e6698 = local_3[1u];
let _e6701 = (_e6645 + (((_e6685 + ((f32(bitcast<i32>(((_e6678 >> bitcast<u32>((_e6686 & 31u))) & 65535u))) - _e6685) * _e6693)) - _e6645) * _e6698));
let _e6703 = local_2.member[1u];
let _e6704 = ((_e6577 + _e6574) + _e6703);
let _e6706 = (_e6704 >> bitcast<u32>(1i));
let _e6709 = bitcast<u32>(((_e6704 & 1i) * 16i));
let _e6711 = select(_e3820, _e6706, (_e6706 < _e3820));
let _e6716 = global_2.member[bitcast<u32>(select(0i, _e6711, (_e6711 > 0i)))];
let _e6720 = (_e6706 + 1i);
let _e6722 = select(_e3820, _e6720, (_e6720 < _e3820));
let _e6727 = global_2.member[bitcast<u32>(select(0i, _e6722, (_e6722 > 0i)))];
let _e6734 = ((_e6716 >> bitcast<u32>((_e6709 & 31u))) | ((_e6727 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6709) & 31u))));
let _e6735 = local_2.member_1[2u];
let _e6741 = f32(bitcast<i32>(((_e6734 >> bitcast<u32>((_e6735 & 31u))) & 65535u)));
let _e6742 = local_2.member_1[3u];
let _e6749 = local_3[0u];
let _e6752 = (_e6741 + ((f32(bitcast<i32>(((_e6734 >> bitcast<u32>((_e6742 & 31u))) & 65535u))) - _e6741) * _e6749));
let _e6754 = local_2.member[1u];
let _e6755 = ((_e6577 + _e6575) + _e6754);
let _e6757 = (_e6755 >> bitcast<u32>(1i));
let _e6760 = bitcast<u32>(((_e6755 & 1i) * 16i));
let _e6762 = select(_e3820, _e6757, (_e6757 < _e3820));
let _e6767 = global_2.member[bitcast<u32>(select(0i, _e6762, (_e6762 > 0i)))];
let _e6771 = (_e6757 + 1i);
let _e6773 = select(_e3820, _e6771, (_e6771 < _e3820));
let _e6778 = global_2.member[bitcast<u32>(select(0i, _e6773, (_e6773 > 0i)))];
let _e6785 = ((_e6767 >> bitcast<u32>((_e6760 & 31u))) | ((_e6778 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6760) & 31u))));
let _e6786 = local_2.member_1[2u];
let _e6792 = f32(bitcast<i32>(((_e6785 >> bitcast<u32>((_e6786 & 31u))) & 65535u)));
let _e6793 = local_2.member_1[3u];
let _e6800 = local_3[0u];
let _e6804 = local_3[1u];
let _e6809 = local_3[2u];
let _e6814 = (((_e6701 + (((_e6752 + (((_e6792 + ((f32(bitcast<i32>(((_e6785 >> bitcast<u32>((_e6793 & 31u))) & 65535u))) - _e6792) * _e6800)) - _e6752) * _e6804)) - _e6701) * _e6809)) - _e4038) * _e4042);
let _e6816 = select(_e4045, _e6814, (_e6814 > _e4045));
local = select(1e9f, _e6816, (_e6816 < 1e9f));
let _e6819 = local;
local_1 = _e6819;
let _e6820 = local_1;
let _e6822 = (bitcast<i32>(_e163) - 1i);
let _e6824 = select(_e6822, 263197i, (263197i < _e6822));
let _e6829 = global_3.member[bitcast<u32>(select(0i, _e6824, (_e6824 > 0i)))];
let _e6832 = select(_e6822, 263198i, (263198i < _e6822));
let _e6837 = global_3.member[bitcast<u32>(select(0i, _e6832, (_e6832 > 0i)))];
let _e6840 = select(_e6822, 263199i, (263199i < _e6822));
let _e6845 = global_3.member[bitcast<u32>(select(0i, _e6840, (_e6840 > 0i)))];
let _e6846 = bitcast<f32>(_e6845);
let _e6848 = ((_e6820 - bitcast<f32>(_e6829)) * bitcast<f32>(_e6837));
let _e6850 = select(0f, _e6848, (_e6848 > 0f));
let _e6853 = local_1;
let _e6855 = select(_e6822, 263200i, (263200i < _e6822));
let _e6860 = global_3.member[bitcast<u32>(select(0i, _e6855, (_e6855 > 0i)))];
let _e6863 = select(_e6822, 263201i, (263201i < _e6822));
let _e6868 = global_3.member[bitcast<u32>(select(0i, _e6863, (_e6863 > 0i)))];
let _e6871 = select(_e6822, 263202i, (263202i < _e6822));
let _e6876 = global_3.member[bitcast<u32>(select(0i, _e6871, (_e6871 > 0i)))];
let _e6877 = bitcast<f32>(_e6876);
let _e6879 = ((_e6853 - bitcast<f32>(_e6860)) * bitcast<f32>(_e6868));
let _e6881 = select(0f, _e6879, (_e6879 > 0f));
let _e6885 = local_1;
let _e6887 = select(_e6822, 263203i, (263203i < _e6822));
let _e6892 = global_3.member[bitcast<u32>(select(0i, _e6887, (_e6887 > 0i)))];
let _e6895 = select(_e6822, 263204i, (263204i < _e6822));
let _e6900 = global_3.member[bitcast<u32>(select(0i, _e6895, (_e6895 > 0i)))];
let _e6903 = select(_e6822, 263205i, (263205i < _e6822));
let _e6908 = global_3.member[bitcast<u32>(select(0i, _e6903, (_e6903 > 0i)))];
let _e6909 = bitcast<f32>(_e6908);
let _e6911 = ((_e6885 - bitcast<f32>(_e6892)) * bitcast<f32>(_e6900));
let _e6913 = select(0f, _e6911, (_e6911 > 0f));
let _e6916 = local_1;
let _e6918 = select(_e6822, 263206i, (263206i < _e6822));
let _e6923 = global_3.member[bitcast<u32>(select(0i, _e6918, (_e6918 > 0i)))];
let _e6926 = select(_e6822, 263207i, (263207i < _e6822));
let _e6931 = global_3.member[bitcast<u32>(select(0i, _e6926, (_e6926 > 0i)))];
let _e6934 = select(_e6822, 263208i, (263208i < _e6822));
let _e6939 = global_3.member[bitcast<u32>(select(0i, _e6934, (_e6934 > 0i)))];
let _e6940 = bitcast<f32>(_e6939);
let _e6942 = ((_e6916 - bitcast<f32>(_e6923)) * bitcast<f32>(_e6931));
let _e6944 = select(0f, _e6942, (_e6942 > 0f));
let _e6948 = ((select(_e6846, _e6850, (_e6850 < _e6846)) + select(_e6877, _e6881, (_e6881 < _e6877))) + (select(_e6909, _e6913, (_e6913 < _e6909)) + select(_e6940, _e6944, (_e6944 < _e6940))));
let _e6950 = select(0f, _e6948, (_e6948 > 0f));
let _e6952 = select(1023f, _e6950, (_e6950 < 1023f));
let _e6959 = select(0i, select(select(i32(_e6952), i32(-2147483648), (_e6952 < -2147483600f)), 2147483647i, (_e6952 > 2147483500f)), (_e6952 == _e6952));
let _e6963 = (_e6959 - select(0i, 1i, (_e6952 < f32(_e6959))));
let _e6964 = (262147i + _e6963);
let _e6966 = select(_e6822, _e6964, (_e6964 < _e6822));
let _e6972 = global_3.member[bitcast<u32>(select(0i, _e6966, (_e6966 > 0i)))];
let _e6982 = select(_e6822, 262146i, (262146i < _e6822));
let _e6988 = global_3.member[bitcast<u32>(select(0i, _e6982, (_e6982 > 0i)))];
let _e6992 = select(_e6822, 262144i, (262144i < _e6822));
let _e6998 = global_3.member[bitcast<u32>(select(0i, _e6992, (_e6992 > 0i)))];
let _e7001 = select(_e6822, 262145i, (262145i < _e6822));
let _e7007 = global_3.member[bitcast<u32>(select(0i, _e7001, (_e7001 > 0i)))];
let _e7014 = ((bitcast<f32>(_e6998) + (f32(bitcast<i32>((_e6972 >> bitcast<u32>(12u)))) * bitcast<f32>(_e7007))) + ((f32((bitcast<i32>((_e6972 & 4095u)) - 2048i)) * bitcast<f32>(_e6988)) * (_e6948 - f32(_e6963))));
let _e7018 = select(_e6416.member_6.x, _e6427.x, _e6421);
let _e7021 = select(_e6416.member_6.y, _e6427.y, _e6421);
let _e7024 = select(_e6416.member_6.z, _e6427.z, _e6421);
let _e7025 = select(1f, _e7014, _e6420);
let _e7030 = (((_e7018 * _e7018) + (_e7021 * _e7021)) + (_e7024 * _e7024));
let _e7033 = sqrt(select(0f, _e7030, (_e7030 > 0f)));
let _e7036 = (1f / select(1e-20f, _e7033, (_e7033 > 1e-20f)));
let _e7037 = (_e7018 * _e7036);
let _e7038 = (_e7021 * _e7036);
let _e7039 = (_e7024 * _e7036);
let _e7044 = (((_e231 * _e7037) + (_e242 * _e7038)) + (_e253 * _e7039));
let _e7049 = (((_e231 * _e231) + (_e242 * _e242)) + (_e253 * _e253));
let _e7051 = ((_e7025 * _e7025) - _e7049);
let _e7052 = (_e7044 * _e7044);
let _e7053 = (_e7052 + _e7051);
let _e7056 = sqrt(select(0f, _e7053, (_e7053 > 0f)));
let _e7060 = (_e7053 <= 0f);
let _e7063 = select((select(_e7056, -(_e7056), (_e7044 < 0f)) - _e7044), (-2f * _e7044), _e7060);
let _e7064 = (_e7051 == 0f);
let _e7075 = (_e7060 && (_e7051 != 0f));
let _e7081 = (!(_e6421) && (_e7075 || (_e7052 < ((0.1f * 0.1f) * _e7049))));
let _e7083 = select(1e-12f, _e7049, (_e7049 > 1e-12f));
let _e7087 = (_e7025 / sqrt(select(0f, _e7083, (_e7083 > 0f))));
let _e7099 = ((_e6421 || (bitcast<f32>((bitcast<u32>(_e6416.member_4) & 2147483647u)) < select(1f, _e6442, (_e6442 < 1f)))) && (_e7014 != 1f));
let _e7100 = select(_e231, select(select(select((_e231 + (_e7037 * _e7063)), _e231, _e7064), _e231, _e7075), (_e231 * _e7087), _e7081), _e7099);
let _e7101 = select(_e242, select(select(select((_e242 + (_e7038 * _e7063)), _e242, _e7064), _e242, _e7075), (_e242 * _e7087), _e7081), _e7099);
let _e7102 = select(_e253, select(select(select((_e253 + (_e7039 * _e7063)), _e253, _e7064), _e253, _e7075), (_e253 * _e7087), _e7081), _e7099);
let _e7114 = global_1.member.member_7.member_2;
let _e7117 = (_e7114 / select(1e-6f, _e7102, (_e7102 > 1e-6f)));
let _e7121 = (_e1150 + (_e7100 * _e7117));
let _e7122 = (_e1155 + (_e7101 * _e7117));
let _e7123 = (_e1144 + (_e7102 * _e7117));
let _e7129 = ((((_e1159.member.member * _e7121) + (_e1159.member.member_1 * _e7122)) + (_e1159.member.member_2 * _e7123)) + _e1159.member_1);
let _e7135 = ((((_e1174.member.member * _e7121) + (_e1174.member.member_1 * _e7122)) + (_e1174.member.member_2 * _e7123)) + _e1174.member_1);
let _e7141 = ((((_e1189.member.member * _e7121) + (_e1189.member.member_1 * _e7122)) + (_e1189.member.member_2 * _e7123)) + _e1189.member_1);
let _e7142 = (-0.5f - _e7129);
let _e7143 = -(_e5858);
let _e7146 = (_e5858 - _e7142);
let _e7147 = (_e7142 - _e5858);
let _e7149 = select(_e7147, _e7146, (_e7146 > _e7147));
let _e7152 = (select(_e7143, _e5858, (_e5858 > _e7143)) / select(1e-30f, _e7149, (_e7149 > 1e-30f)));
let _e7155 = select(0f, select(2f, _e7152, (_e7142 < 0f)), _e5873);
let _e7158 = select(2f, select(0f, _e7152, _e5870), (_e7142 > 0f));
let _e7162 = ((_e7155 > -1f) || ((_e7155 == -1f) && _e5892));
let _e7163 = (_e7158 < 2f);
let _e7164 = select(-1f, _e7155, _e7162);
let _e7168 = select(2f, _e7158, _e7163);
let _e7173 = select(-1e30f, _e7142, (_e7142 > -1e30f));
let _e7177 = (_e7129 - _e3644);
let _e7178 = -(_e5898);
let _e7181 = (_e5898 - _e7177);
let _e7182 = (_e7177 - _e5898);
let _e7184 = select(_e7182, _e7181, (_e7181 > _e7182));
let _e7187 = (select(_e7178, _e5898, (_e5898 > _e7178)) / select(1e-30f, _e7184, (_e7184 > 1e-30f)));
let _e7190 = select(0f, select(2f, _e7187, (_e7177 < 0f)), _e5913);
let _e7193 = select(2f, select(0f, _e7187, _e5910), (_e7177 > 0f));
let _e7197 = ((_e7190 > _e7164) || ((_e7190 == _e7164) && _e5932));
let _e7198 = (_e7193 < _e7168);
let _e7199 = select(_e7164, _e7190, _e7197);
let _e7203 = select(_e7168, _e7193, _e7198);
let _e7208 = select(_e7173, _e7177, (_e7177 > _e7173));
let _e7212 = (-0.5f - _e7135);
let _e7213 = -(_e5937);
let _e7216 = (_e5937 - _e7212);
let _e7217 = (_e7212 - _e5937);
let _e7219 = select(_e7217, _e7216, (_e7216 > _e7217));
let _e7222 = (select(_e7213, _e5937, (_e5937 > _e7213)) / select(1e-30f, _e7219, (_e7219 > 1e-30f)));
let _e7225 = select(0f, select(2f, _e7222, (_e7212 < 0f)), _e5952);
let _e7228 = select(2f, select(0f, _e7222, _e5949), (_e7212 > 0f));
let _e7232 = ((_e7225 > _e7199) || ((_e7225 == _e7199) && _e5971));
let _e7233 = (_e7228 < _e7203);
let _e7234 = select(_e7199, _e7225, _e7232);
let _e7238 = select(_e7203, _e7228, _e7233);
let _e7243 = select(_e7208, _e7212, (_e7212 > _e7208));
let _e7247 = (_e7135 - _e3654);
let _e7248 = -(_e5977);
let _e7251 = (_e5977 - _e7247);
let _e7252 = (_e7247 - _e5977);
let _e7254 = select(_e7252, _e7251, (_e7251 > _e7252));
let _e7257 = (select(_e7248, _e5977, (_e5977 > _e7248)) / select(1e-30f, _e7254, (_e7254 > 1e-30f)));
let _e7260 = select(0f, select(2f, _e7257, (_e7247 < 0f)), _e5992);
let _e7263 = select(2f, select(0f, _e7257, _e5989), (_e7247 > 0f));
let _e7267 = ((_e7260 > _e7234) || ((_e7260 == _e7234) && _e6011));
let _e7268 = (_e7263 < _e7238);
let _e7269 = select(_e7234, _e7260, _e7267);
let _e7273 = select(_e7238, _e7263, _e7268);
let _e7278 = select(_e7243, _e7247, (_e7247 > _e7243));
let _e7282 = (-0.5f - _e7141);
let _e7283 = -(_e6016);
let _e7286 = (_e6016 - _e7282);
let _e7287 = (_e7282 - _e6016);
let _e7289 = select(_e7287, _e7286, (_e7286 > _e7287));
let _e7292 = (select(_e7283, _e6016, (_e6016 > _e7283)) / select(1e-30f, _e7289, (_e7289 > 1e-30f)));
let _e7295 = select(0f, select(2f, _e7292, (_e7282 < 0f)), _e6031);
let _e7298 = select(2f, select(0f, _e7292, _e6028), (_e7282 > 0f));
let _e7302 = ((_e7295 > _e7269) || ((_e7295 == _e7269) && _e6050));
let _e7303 = (_e7298 < _e7273);
let _e7304 = select(_e7269, _e7295, _e7302);
let _e7308 = select(_e7273, _e7298, _e7303);
let _e7313 = select(_e7278, _e7282, (_e7282 > _e7278));
let _e7317 = (_e7141 - _e3664);
let _e7318 = -(_e6056);
let _e7321 = (_e6056 - _e7317);
let _e7322 = (_e7317 - _e6056);
let _e7324 = select(_e7322, _e7321, (_e7321 > _e7322));
let _e7327 = (select(_e7318, _e6056, (_e6056 > _e7318)) / select(1e-30f, _e7324, (_e7324 > 1e-30f)));
let _e7330 = select(0f, select(2f, _e7327, (_e7317 < 0f)), _e6071);
let _e7333 = select(2f, select(0f, _e7327, _e6068), (_e7317 > 0f));
let _e7337 = ((_e7330 > _e7304) || ((_e7330 == _e7304) && _e6092));
let _e7338 = (_e7333 < _e7308);
let _e7339 = select(_e7304, _e7330, _e7337);
let _e7340 = select(select(select(select(select(select(0f, _e5838.member, _e7162), _e5838.member, _e7197), _e5846.member, _e7232), _e5846.member, _e7267), _e5854.member, _e7302), _e5854.member, _e7337);
let _e7341 = select(select(select(select(select(select(0f, _e5838.member_1, _e7162), _e5838.member_1, _e7197), _e5846.member_1, _e7232), _e5846.member_1, _e7267), _e5854.member_1, _e7302), _e5854.member_1, _e7337);
let _e7342 = select(select(select(select(select(select(1f, _e5838.member_2, _e7162), _e5838.member_2, _e7197), _e5846.member_2, _e7232), _e5846.member_2, _e7267), _e5854.member_2, _e7302), _e5854.member_2, _e7337);
let _e7344 = select(_e7308, _e7333, _e7338);
let _e7345 = select(select(select(select(select(select(0f, _e5838.member, _e7163), _e5838.member, _e7198), _e5846.member, _e7233), _e5846.member, _e7268), _e5854.member, _e7303), _e5854.member, _e7338);
let _e7346 = select(select(select(select(select(select(0f, _e5838.member_1, _e7163), _e5838.member_1, _e7198), _e5846.member_1, _e7233), _e5846.member_1, _e7268), _e5854.member_1, _e7303), _e5854.member_1, _e7338);
let _e7347 = select(select(select(select(select(select(1f, _e5838.member_2, _e7163), _e5838.member_2, _e7198), _e5846.member_2, _e7233), _e5846.member_2, _e7268), _e5854.member_2, _e7303), _e5854.member_2, _e7338);
let _e7350 = select(_e7313, _e7317, (_e7317 > _e7313));
let _e7351 = select(select(select(select(select(select(0f, _e5838.member, _e5892), _e5838.member, _e5932), _e5846.member, _e5971), _e5846.member, _e6011), _e5854.member, _e6050), _e5854.member, _e6092);
let _e7352 = select(select(select(select(select(select(0f, _e5838.member_1, _e5892), _e5838.member_1, _e5932), _e5846.member_1, _e5971), _e5846.member_1, _e6011), _e5854.member_1, _e6050), _e5854.member_1, _e6092);
let _e7353 = select(select(select(select(select(select(1f, _e5838.member_2, _e5892), _e5838.member_2, _e5932), _e5846.member_2, _e5971), _e5846.member_2, _e6011), _e5854.member_2, _e6050), _e5854.member_2, _e6092);
if _e4054 {
phi_17014_ = type_34(_e7339, vec3<f32>(_e7340, _e7341, _e7342), _e7344, vec3<f32>(_e7345, _e7346, _e7347), _e6093, _e7350, vec3<f32>(_e7351, _e7352, _e7353));
} else {
let _e7359 = global_1.member.member_16.member_1;
let _e7360 = (_e7359 != 0u);
let _e7364 = global_1.member.member_16.member;
let _e7384 = select(-1e6f, (((((_e7364.member.member * _e1150) + (_e7364.member.member_1 * _e1155)) + (_e7364.member.member_2 * _e1144)) + _e7364.member_1) * _e6441), _e7360);
let _e7385 = select(-1e6f, (((((_e7364.member.member * _e7121) + (_e7364.member.member_1 * _e7122)) + (_e7364.member.member_2 * _e7123)) + _e7364.member_1) * _e6441), _e7360);
let _e7390 = global_1.member.member_16.member.member;
let _e7394 = -(_e7384);
let _e7397 = (_e7384 - _e7385);
let _e7398 = (_e7385 - _e7384);
let _e7400 = select(_e7398, _e7397, (_e7397 > _e7398));
let _e7403 = (select(_e7394, _e7384, (_e7384 > _e7394)) / select(1e-30f, _e7400, (_e7400 > 1e-30f)));
let _e7407 = select(0f, select(2f, _e7403, (_e7385 < 0f)), (_e7384 > 0f));
let _e7411 = select(2f, select(0f, _e7403, (_e7384 < 0f)), (_e7385 > 0f));
let _e7412 = (_e7384 > _e6093);
let _e7416 = ((_e7407 > _e7339) || ((_e7407 == _e7339) && _e7412));
let _e7417 = (_e7411 < _e7344);
let _e7418 = select(_e7339, _e7407, _e7416);
let _e7422 = select(_e7344, _e7411, _e7417);
let _e7426 = select(_e6093, _e7384, _e7412);
let _e7428 = select(_e7350, _e7385, (_e7385 > _e7350));
let _e7435 = global_1.member.member_17.member_1;
let _e7436 = (_e7435 != 0u);
let _e7440 = global_1.member.member_17.member;
let _e7460 = select(-1e6f, (((((_e7440.member.member * _e1150) + (_e7440.member.member_1 * _e1155)) + (_e7440.member.member_2 * _e1144)) + _e7440.member_1) * _e6441), _e7436);
let _e7461 = select(-1e6f, (((((_e7440.member.member * _e7121) + (_e7440.member.member_1 * _e7122)) + (_e7440.member.member_2 * _e7123)) + _e7440.member_1) * _e6441), _e7436);
let _e7466 = global_1.member.member_17.member.member;
let _e7470 = -(_e7460);
let _e7473 = (_e7460 - _e7461);
let _e7474 = (_e7461 - _e7460);
let _e7476 = select(_e7474, _e7473, (_e7473 > _e7474));
let _e7479 = (select(_e7470, _e7460, (_e7460 > _e7470)) / select(1e-30f, _e7476, (_e7476 > 1e-30f)));
let _e7483 = select(0f, select(2f, _e7479, (_e7461 < 0f)), (_e7460 > 0f));
let _e7487 = select(2f, select(0f, _e7479, (_e7460 < 0f)), (_e7461 > 0f));
let _e7488 = (_e7460 > _e7426);
let _e7492 = ((_e7483 > _e7418) || ((_e7483 == _e7418) && _e7488));
let _e7493 = (_e7487 < _e7422);
let _e7494 = select(_e7418, _e7483, _e7492);
let _e7498 = select(_e7422, _e7487, _e7493);
let _e7502 = select(_e7426, _e7460, _e7488);
let _e7504 = select(_e7428, _e7461, (_e7461 > _e7428));
let _e7511 = global_1.member.member_18.member_1;
let _e7512 = (_e7511 != 0u);
let _e7516 = global_1.member.member_18.member;
let _e7536 = select(-1e6f, (((((_e7516.member.member * _e1150) + (_e7516.member.member_1 * _e1155)) + (_e7516.member.member_2 * _e1144)) + _e7516.member_1) * _e6441), _e7512);
let _e7537 = select(-1e6f, (((((_e7516.member.member * _e7121) + (_e7516.member.member_1 * _e7122)) + (_e7516.member.member_2 * _e7123)) + _e7516.member_1) * _e6441), _e7512);
let _e7542 = global_1.member.member_18.member.member;
let _e7546 = -(_e7536);
let _e7549 = (_e7536 - _e7537);
let _e7550 = (_e7537 - _e7536);
let _e7552 = select(_e7550, _e7549, (_e7549 > _e7550));
let _e7555 = (select(_e7546, _e7536, (_e7536 > _e7546)) / select(1e-30f, _e7552, (_e7552 > 1e-30f)));
let _e7559 = select(0f, select(2f, _e7555, (_e7537 < 0f)), (_e7536 > 0f));
let _e7563 = select(2f, select(0f, _e7555, (_e7536 < 0f)), (_e7537 > 0f));
let _e7564 = (_e7536 > _e7502);
let _e7568 = ((_e7559 > _e7494) || ((_e7559 == _e7494) && _e7564));
let _e7569 = (_e7563 < _e7498);
let _e7570 = select(_e7494, _e7559, _e7568);
let _e7574 = select(_e7498, _e7563, _e7569);
let _e7578 = select(_e7502, _e7536, _e7564);
let _e7580 = select(_e7504, _e7537, (_e7537 > _e7504));
let _e7587 = global_1.member.member_19.member_1;
let _e7588 = (_e7587 != 0u);
let _e7592 = global_1.member.member_19.member;
let _e7612 = select(-1e6f, (((((_e7592.member.member * _e1150) + (_e7592.member.member_1 * _e1155)) + (_e7592.member.member_2 * _e1144)) + _e7592.member_1) * _e6441), _e7588);
let _e7613 = select(-1e6f, (((((_e7592.member.member * _e7121) + (_e7592.member.member_1 * _e7122)) + (_e7592.member.member_2 * _e7123)) + _e7592.member_1) * _e6441), _e7588);
let _e7618 = global_1.member.member_19.member.member;
let _e7622 = -(_e7612);
let _e7625 = (_e7612 - _e7613);
let _e7626 = (_e7613 - _e7612);
let _e7628 = select(_e7626, _e7625, (_e7625 > _e7626));
let _e7631 = (select(_e7622, _e7612, (_e7612 > _e7622)) / select(1e-30f, _e7628, (_e7628 > 1e-30f)));
let _e7635 = select(0f, select(2f, _e7631, (_e7613 < 0f)), (_e7612 > 0f));
let _e7639 = select(2f, select(0f, _e7631, (_e7612 < 0f)), (_e7613 > 0f));
let _e7640 = (_e7612 > _e7578);
let _e7644 = ((_e7635 > _e7570) || ((_e7635 == _e7570) && _e7640));
let _e7645 = (_e7639 < _e7574);
phi_17014_ = type_34(select(_e7570, _e7635, _e7644), vec3<f32>(select(select(select(select(_e7340, _e7390.member, _e7416), _e7466.member, _e7492), _e7542.member, _e7568), _e7618.member, _e7644), select(select(select(select(_e7341, _e7390.member_1, _e7416), _e7466.member_1, _e7492), _e7542.member_1, _e7568), _e7618.member_1, _e7644), select(select(select(select(_e7342, _e7390.member_2, _e7416), _e7466.member_2, _e7492), _e7542.member_2, _e7568), _e7618.member_2, _e7644)), select(_e7574, _e7639, _e7645), vec3<f32>(select(select(select(select(_e7345, _e7390.member, _e7417), _e7466.member, _e7493), _e7542.member, _e7569), _e7618.member, _e7645), select(select(select(select(_e7346, _e7390.member_1, _e7417), _e7466.member_1, _e7493), _e7542.member_1, _e7569), _e7618.member_1, _e7645), select(select(select(select(_e7347, _e7390.member_2, _e7417), _e7466.member_2, _e7493), _e7542.member_2, _e7569), _e7618.member_2, _e7645)), select(_e7578, _e7612, _e7640), select(_e7580, _e7613, (_e7613 > _e7580)), vec3<f32>(select(select(select(select(_e7351, _e7390.member, _e7412), _e7466.member, _e7488), _e7542.member, _e7564), _e7618.member, _e7640), select(select(select(select(_e7352, _e7390.member_1, _e7412), _e7466.member_1, _e7488), _e7542.member_1, _e7564), _e7618.member_1, _e7640), select(select(select(select(_e7353, _e7390.member_2, _e7412), _e7466.member_2, _e7488), _e7542.member_2, _e7564), _e7618.member_2, _e7640)));
}
let _e7665 = phi_17014_;
let _e7674 = global_1.member.member_7.member_4;
let _e7677 = (_e3638.member_3.x * _e4257.member_2);
let _e7679 = (_e3638.member_3.y * _e4257.member_2);
let _e7681 = (_e3638.member_3.z * _e4257.member_2);
let _e7682 = (0.5f * (_e7117 * select(1f, (2f * (1f - _e6429)), (_e6421 && _e6420))));
let _e7686 = (_e7100 + (_e7677 * _e7682));
let _e7687 = (_e7101 + (_e7679 * _e7682));
let _e7688 = (_e7102 + (_e7681 * _e7682));
let _e7690 = (2f * _e7114);
let _e7692 = ((_e7688 * _e7688) + (_e7690 * _e7681));
let _e7696 = (_e7688 + sqrt(select(0f, _e7692, (_e7692 > 0f))));
let _e7700 = (select(0.5f, _e7665.member_2, (_e7665.member_2 < 1f)) * (_e7690 / select(1e-6f, _e7696, (_e7696 > 1e-6f))));
let _e7704 = (_e7686 + (_e7677 * _e7700));
let _e7705 = (_e7687 + (_e7679 * _e7700));
let _e7706 = (_e7688 + (_e7681 * _e7700));
let _e7710 = (_e7674 * _e7674);
let _e7712 = (_e7706 * _e7706);
let _e7720 = (((_e7688 <= 0f) || (_e7692 <= 0f)) || ((_e7706 <= 0f) || (_e7712 <= (_e7710 * (((_e7704 * _e7704) + (_e7705 * _e7705)) + _e7712)))));
let _e7734 = (_e7100 + ((_e3638.member_4.x * _e4257.member_2) * _e7114));
let _e7735 = (_e7101 + ((_e3638.member_4.y * _e4257.member_2) * _e7114));
let _e7736 = (_e7102 + ((_e3638.member_4.z * _e4257.member_2) * _e7114));
let _e7738 = (_e7736 * _e7736);
let _e7747 = ((_e4052 & 1u) != 0u);
let _e7752 = (select(_e7720, ((_e7736 <= 0f) || (_e7738 <= (_e7710 * (((_e7734 * _e7734) + (_e7735 * _e7735)) + _e7738)))), _e7747) || (_e7099 && ((_e7075 && _e6421) || (_e6421 && (_e7102 <= 0f)))));
phi_17166_ = vec3<f32>(select(select(select(_e7704, _e7686, _e7720), _e7734, _e7747), _e231, _e7752), select(select(select(_e7705, _e7687, _e7720), _e7735, _e7747), _e242, _e7752), select(select(select(_e7706, _e7688, _e7720), _e7736, _e7747), _e253, _e7752));
phi_17167_ = select(1f, 0f, _e7752);
} else {
phi_17166_ = vec3<f32>(_e231, _e242, _e253);
phi_17167_ = 1f;
}
let _e7759 = phi_17166_;
let _e7761 = phi_17167_;
let _e7764 = (_e5833.member * _e7761);
global_4.member[_e188] = (_e199 * (_e5833.member_2.x * _e7764));
global_4.member[_e200] = (_e209 * (_e5833.member_2.y * _e7764));
global_4.member[_e211] = (_e220 * (_e5833.member_2.z * _e7764));
global_4.member[_e222] = _e7759.x;
global_4.member[_e233] = _e7759.y;
global_4.member[_e244] = _e7759.z;
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
